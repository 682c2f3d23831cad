#include "Improvement/VertexLink.h"

#include "Geometry/TetrahedronMeasures.h"
#include "Mesh/Traversal.h"
#include "Support/GridMesh.h"
#include "Support/Invariants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace
{
using namespace ransmesh;

class VertexLinks : public testing::Test
{
protected:
  // The worst quality that a collapse of v onto apex would leave, worked out plainly.
  double plainWorst(Index v, Index apex)
  {
    std::vector<Index> ball;
    Traversal(mesh_).ball(v, ball);
    double worst = std::numeric_limits<double>::infinity();
    for (const Index t : ball)
    {
      const Tetrahedron& tet = mesh_.tet(t);
      if (!tet.has(apex))
      {
        const auto f = tet.face(tet.cornerOf(v));
        worst = std::min(
          worst, quality(mesh_.point(f[0]), mesh_.point(f[1]), mesh_.point(f[2]), mesh_.point(apex)));
      }
    }
    return worst;
  }

  TetMesh mesh_ = invariants::build(grid_mesh::make({ 4, 4, 4, grid_mesh::turned, 0.25 }));
};

TEST_F(VertexLinks, SeeTheBallAndItsEnds)
{
  VertexLink link(mesh_);
  for (Index v = 0; v < static_cast<Index>(mesh_.vertexCount()); ++v)
  {
    link.turnTo(v);
    std::vector<Index> ball;
    Traversal(mesh_).ball(v, ball);
    EXPECT_TRUE(std::is_permutation(ball.begin(), ball.end(), link.ball().begin(), link.ball().end()));
    for (std::size_t i = 0; i < link.ends().size(); ++i)
    {
      EXPECT_NE(link.ends()[i], v);
      EXPECT_EQ(link.places()[i], mesh_.point(link.ends()[i]) - mesh_.point(v));
    }
  }
}

TEST_F(VertexLinks, JudgeEveryCollapse)
{
  VertexLink link(mesh_);
  std::size_t good = 0;
  for (Index v = 0; v < static_cast<Index>(mesh_.vertexCount()); ++v)
  {
    link.turnTo(v);
    for (int end = 0; end < static_cast<int>(link.ends().size()); ++end)
    {
      const double expected = plainWorst(v, link.ends()[end]);
      if (expected < std::numeric_limits<double>::infinity())
      {
        EXPECT_NEAR(link.worstFrom(end, -10), expected, 1e-12);
        EXPECT_EQ(link.allPositiveFrom(end), expected > 0);
        const std::size_t poor = link.countPoor(end, 0.1, link.ball().size());
        EXPECT_EQ(poor > 0, expected <= 0.1);
        EXPECT_EQ(link.countPoor(end, 0.1, poor), poor) << "gives up";
        EXPECT_DOUBLE_EQ(link.worstFrom(end, expected + 0.1), expected + 0.1) << "gives up";
        good += expected > 0.1;
      }
    }
  }
  EXPECT_GT(good, 10u);
}

TEST_F(VertexLinks, GrowUntilTheFloorIsReached)
{
  VertexLink link(mesh_);
  const PatchTable patches = grid_mesh::patches(PatchType::Wall);
  const BoundaryRules rules{ classify(mesh_, patches), std::vector<char>(patches.size(), 0) };
  std::size_t grown = 0;
  for (Index v = 0; v < static_cast<Index>(mesh_.vertexCount()); ++v)
  {
    link.turnTo(v);
    for (int end = 0; end < static_cast<int>(link.ends().size()); ++end)
    {
      constexpr double floor = 0.1;
      const double before = link.worstFrom(end, -10);
      const double after = link.grow(end, floor, 6, rules);
      EXPECT_LE(link.grownTets().size(), 6u);
      EXPECT_TRUE(link.grownStarred().empty()) << "no patch may change";
      EXPECT_EQ(link.grownTets().empty() && after > floor, before > floor);
      grown += before <= floor && after > floor;
      EXPECT_EQ(link.worstFrom(end, -10), before) << "growth must leave no trace";
    }
  }
  EXPECT_GT(grown, 10u);
}
} // namespace

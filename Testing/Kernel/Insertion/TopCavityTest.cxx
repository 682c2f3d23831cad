#include "Insertion/TopCavity.h"

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

class TopCavities : public testing::Test
{
protected:
  TetMesh mesh_ = invariants::build(grid_mesh::make({ 4, 4, 4, grid_mesh::turned, 0.25 }));
  Star star_{ mesh_ };
  TopCavity cavity_{ mesh_ };

  std::vector<Index> ballOf(Index v)
  {
    std::vector<Index> ball;
    Traversal(mesh_).ball(v, ball);
    return ball;
  }

  // The worst quality of what starring the cavity makes, worked out plainly.
  double plainWorst() const
  {
    double worst = std::numeric_limits<double>::infinity();
    for (const auto& v : star_.newTets())
    {
      worst =
        std::min(worst, quality(mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]), mesh_.point(v[3])));
    }
    return worst;
  }
};

TEST_F(TopCavities, GrowUntilTheApexSeesAllOfThemWell)
{
  constexpr double wanted = 0.05;
  constexpr std::size_t growth = 8;
  std::size_t grown = 0;
  for (Index v = 0; v < static_cast<Index>(mesh_.vertexCount()); ++v)
  {
    const std::vector<Index> ball = ballOf(v);
    cavity_.begin(ball, mesh_.point(v));
    for (const Index apex : mesh_.tet(ball.front()).vertex)
    {
      if (!cavity_.grow(apex, wanted, ball.size() + growth, nullptr))
      {
        continue;
      }
      EXPECT_LE(cavity_.cavity().tets.size(), ball.size() + growth);
      EXPECT_TRUE(std::equal(ball.begin(), ball.end(), cavity_.cavity().tets.begin()));
      EXPECT_GT(cavity_.worst(), wanted);
      if (star_.check(cavity_.cavity(), apex) == StarVerdict::Possible)
      {
        EXPECT_NEAR(cavity_.worst(), plainWorst(), 1e-9);
        grown += cavity_.cavity().tets.size() > ball.size();
      }
    }
  }
  EXPECT_GT(grown, 0U);
}

TEST_F(TopCavities, TakeTheBoundaryFacesOfTheirSidesAlong)
{
  const Index v = mesh_.boundaryVertices(0)[0];
  const std::vector<Index> ball = ballOf(v);
  cavity_.begin(ball, mesh_.point(v));
  const int side = mesh_.boundaryFace(0).patch;
  Column column;
  ASSERT_TRUE(cavity_.grow(v, -1, ball.size(), &column)); // without sides
  EXPECT_TRUE(cavity_.cavity().starredFaces.empty());
  column.sides[0] = side;
  ASSERT_TRUE(cavity_.grow(v, -1, ball.size(), &column));
  const auto& starred = cavity_.cavity().starredFaces;
  EXPECT_NE(std::find(starred.begin(), starred.end(), 0), starred.end());
  for (const Index b : starred)
  {
    EXPECT_EQ(mesh_.boundaryFace(b).patch, side);
  }
}
} // namespace

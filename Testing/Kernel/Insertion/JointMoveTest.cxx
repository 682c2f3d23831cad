// Moves of all of the front's tops at once.
#include "Insertion/JointMove.h"

#include "Layers/ColumnBuilder.h"
#include "Layers/SideColumns.h"
#include "Mesh/Builder.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace ransmesh;
using namespace grid_mesh;

namespace
{
// Columns of eight layers of 0.03 on the floor of a mapped cube, the front still on the wall.
struct Floor
{
  TetMesh mesh;
  ColumnSet set;

  explicit Floor(const Grid& grid)
  {
    const PatchTable table = patches(PatchType::Symmetry);
    EXPECT_TRUE(buildTetMesh(make(grid), mesh).ok());
    LayerPlan plan(7);
    plan[ZLow].firstHeight = 0.03;
    plan[ZLow].growthRate = 1;
    plan[ZLow].numberOfLayers = 8;
    const BoundaryStars stars(mesh);
    set = buildColumns(mesh, stars, table, plan);
    followSides(mesh, stars, plan, 0.3, set);
  }
  Index columnAt(const Vector3& x) const
  {
    for (std::size_t i = 0; i < set.columns.size(); ++i)
    {
      if (distance(set.columns[i].base, x) < 1e-9)
      {
        return static_cast<Index>(i);
      }
    }
    throw std::logic_error("no column there");
  }
  // Moves all tops to the share of their height that target gives.
  std::size_t move(const std::vector<double>& target, double maximumSurfaceAngle = 10)
  {
    const SideTurns turns(mesh, set, maximumSurfaceAngle);
    Front front(mesh, set);
    return JointMove(mesh, set, turns, front).run(target);
  }
  std::vector<double> only(Index column, double share) const
  {
    std::vector<double> target(set.columns.size(), 0);
    target[column] = share;
    return target;
  }
};

Vector3 bulgingSides(const Vector3& p)
{
  return { p.x + 0.3 * (1 - p.x) * std::sin(4 * p.z) * std::cos(3 * p.y), p.y, p.z };
}
} // namespace

TEST(JointMove, AllTopsGoWhereThereIsRoom)
{
  Floor floor({ 4, 4, 4 });
  EXPECT_EQ(floor.move(std::vector<double>(25, 0.25)), 25U);
  for (const Column& c : floor.set.columns)
  {
    EXPECT_NEAR(floor.mesh.point(c.vertex).z, 0.06, 1e-15);
  }
}

TEST(JointMove, ATopDoesNotGoBelowTheWall)
{
  Floor floor({ 4, 4, 4 });
  const Index middle = floor.columnAt({ 0.5, 0.5, 0 });
  Column& c = floor.set.columns[middle];
  c.direction = { 0, 0, -0.1 }; // beyond the front there is more room then
  EXPECT_EQ(floor.move(floor.only(middle, 1)), 0U);
  EXPECT_EQ(floor.mesh.point(c.vertex), c.base);
}

TEST(JointMove, ATopDoesNotSquashTheTetrahedraBeyondIt)
{
  Floor floor({ 4, 4, 4 });
  const Index middle = floor.columnAt({ 0.5, 0.5, 0 });
  floor.set.columns[middle].direction = { 0, 0, 0.2499 / 0.24 }; // the next point is at 0.25
  EXPECT_EQ(floor.move(floor.only(middle, 1)), 0U);
  EXPECT_EQ(floor.move(floor.only(middle, 0.2)), 1U);
}

TEST(JointMove, TopsInCurvedSidesTurnNoTriangleAway)
{
  constexpr double strict = 0;
  Floor floor({ 8, 8, 8, bulgingSides });
  const SideTurns turns(floor.mesh, floor.set, strict);
  ASSERT_TRUE(turns.anyCurved());
  std::vector<double> before;
  const auto isWatched = [&](Index b)
  { return floor.mesh.boundaryFace(b).isAlive() && turns.isCurved(floor.mesh.boundaryFace(b).patch); };
  for (std::size_t b = 0; b < floor.mesh.boundarySlots(); ++b)
  {
    const auto face = static_cast<Index>(b);
    before.push_back(isWatched(face) ? turns.faithfulness(face) : 0);
  }
  const std::size_t moved = floor.move(std::vector<double>(floor.set.columns.size(), 0.4), strict);
  EXPECT_GT(moved, 0U);
  EXPECT_LT(moved, floor.set.columns.size());
  for (std::size_t b = 0; b < before.size(); ++b)
  {
    const auto face = static_cast<Index>(b);
    EXPECT_TRUE(!isWatched(face) || turns.allows(turns.faithfulness(face), before[b])) << b;
  }
}

#include "Layers/GapLimits.h"

#include "Layers/ColumnBuilder.h"
#include "Layers/SideColumns.h"
#include "Mesh/Builder.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace ransmesh;
using namespace grid_mesh;

namespace
{
// Columns on the lower side (ZLow) of a mapped cube, twenty levels of a hundredth each.
struct Ground
{
  TetMesh mesh;
  LayerPlan plan;
  ColumnSet set;

  explicit Ground(const Grid& grid, const PatchOf& patchOf = {}, int secondWall = ZLow)
    : plan(8)
  {
    EXPECT_TRUE(buildTetMesh(make(grid, patchOf), mesh).ok());
    plan[ZLow].firstHeight = 0.01;
    plan[ZLow].growthRate = 1;
    plan[ZLow].numberOfLayers = 20;
    plan[secondWall] = plan[ZLow];
    set = buildColumns(mesh, BoundaryStars(mesh), patches(PatchType::Symmetry, 7), plan);
  }
  void limit(double gapFraction)
  {
    const BoundaryStars stars(mesh);
    followSides(mesh, stars, plan, gapFraction, set);
    limitByGap(mesh, stars, gapFraction, set);
  }
  const Column& at(double x, double y) const
  {
    for (const Column& c : set.columns)
    {
      if (std::abs(c.base.x - x) < 1e-12 && std::abs(c.base.y - y) < 1e-12)
      {
        return c;
      }
    }
    throw std::logic_error("no column there");
  }
};

Grid channel(double height, int cells = 3)
{
  return { 6, 6, cells, [height](const Vector3& p) { return Vector3{ p.x, p.y, height * p.z }; } };
}
} // namespace

TEST(GapLimits, TheGapIsMeasuredThroughTheMesh)
{
  for (const int cells : { 1, 3, 7 })
  {
    Ground ground(channel(0.3, cells));
    ground.limit(0.3);
    for (const Column& c : ground.set.columns)
    {
      EXPECT_GE(c.levels, 8) << cells; // 0.3 of 0.3 in steps of 0.01, but for rounding
      EXPECT_LE(c.levels, 9) << cells;
      EXPECT_EQ(c.reason, StopReason::Gap);
    }
  }
}

TEST(GapLimits, AColumnThatLeansKeepsTheHeightOfThoseBesideIt)
{
  Ground ground(channel(0.3), {}, XLow);
  const Column& edge = ground.at(0, 0.5);
  ASSERT_NEAR(norm(edge.direction), std::sqrt(2), 1e-12);
  ground.limit(0.3);
  EXPECT_GE(edge.levels, 8);
  EXPECT_LE(edge.levels, 9);
  EXPECT_EQ(edge.reason, StopReason::Gap);
}

TEST(GapLimits, AWideChannelDoesNotLimit)
{
  Ground ground(channel(1));
  ground.limit(0.3);
  for (const Column& c : ground.set.columns)
  {
    EXPECT_EQ(c.levels, 20);
  }
}

TEST(GapLimits, ColumnsInSidesSeeWhatIsAboveThem)
{
  // The lid comes down along the sides at x = 0 and 1 more than in the middle.
  const auto map = [](const Vector3& p) { return Vector3{ p.x, p.y, p.z * (0.12 + 1.6 * p.x * (1 - p.x)) }; };
  Ground ground({ 6, 6, 4, map });
  ground.limit(0.3);
  EXPECT_EQ(ground.at(0, 0.5).levels, 3);
  EXPECT_EQ(ground.at(0, 0).levels, 3);
  EXPECT_EQ(ground.at(0.5, 0).levels, ground.at(0.5, 0.5).levels);
}

TEST(GapLimits, ASideThatGoesOnUnderAnotherNameIsNoGap)
{
  const auto split = [](Side side, const Vector3& middle)
  { return side == XLow && middle.z > 0.2 ? 7 : static_cast<int>(side); };
  Ground ground({ 5, 5, 5 }, split);
  ground.limit(0.3);
  EXPECT_EQ(ground.at(0, 0.4).levels, 16);
  EXPECT_EQ(ground.at(0.2, 0.4).levels, 20);
}

TEST(GapLimits, EveryWallFaceLooksForItself)
{
  // A roof over the floor's edge: the column there stands along the bisector, which passes the lid by.
  const auto ridge = [](const Vector3& p)
  {
    return Vector3{ p.x, p.y,
      p.x < 0.5 ? p.z * 0.2 : p.z * (0.2 + p.x - 0.5) - 1.2 * (1 - p.z) * (p.x - 0.5) };
  };
  Ground ground({ 6, 6, 1, ridge });
  ground.plan[ZLow].normalAngle = 80; // no fan, whose columns look for themselves
  ground.set =
    buildColumns(ground.mesh, BoundaryStars(ground.mesh), patches(PatchType::Symmetry, 7), ground.plan);
  ASSERT_TRUE(ground.set.fans.empty());
  ground.limit(0.3);
  const Column& edge = ground.at(0.5, 0.5);
  EXPECT_GT(edge.direction.x, 0.4);
  EXPECT_LE(edge.levels, 6);
  EXPECT_EQ(edge.reason, StopReason::Gap);
}

TEST(GapLimits, AColumnThatLeansUnderALowerLidSeesIt)
{
  // The side leans outward, and the lid is low only over that.
  const auto map = [](const Vector3& p)
  {
    const double z = (p.x < 0.1 ? 0.3 : 0.9) * p.z;
    return Vector3{ p.x < 0.1 ? p.x - z : p.x, p.y, z };
  };
  Ground ground({ 6, 6, 4, map });
  const Column& edge = ground.at(0, 0.5);
  ASSERT_NEAR(norm(edge.direction), std::sqrt(2), 1e-9);
  limitByGap(ground.mesh, BoundaryStars(ground.mesh), 0.3, ground.set); // the side's triangles are not asked
  EXPECT_GE(edge.levels, 8);
  EXPECT_LE(edge.levels, 9);
  EXPECT_EQ(edge.reason, StopReason::Gap);
}

TEST(GapLimits, EachColumnOfAFanLooksForItself)
{
  // Over the ridge of a roof the lid comes down to a point; only the fan's middle column points there.
  const auto roof = [](const Vector3& p)
  {
    const double away = std::fabs(p.x - 0.5);
    return Vector3{ p.x, p.y, -1.2 * away + p.z * (0.1 + 4.2 * away) };
  };
  Ground ground({ 6, 6, 1, roof });
  ASSERT_EQ(ground.set.fans.size(), 7U);
  ground.limit(0.3);
  EXPECT_GE(ground.at(0.5, 0.5).levels, 2); // 0.3 of 0.1
  EXPECT_LE(ground.at(0.5, 0.5).levels, 3);
  EXPECT_EQ(ground.at(0.5, 0.5).reason, StopReason::Gap);
}

TEST(GapLimits, WideFacesStayClearOfWhatHangsBetweenTheirCorners)
{
  // A lid with one peak that hangs down over the middle of a square of the floor, whose corners see the lid higher up.
  const auto peak = [](const Vector3& p)
  {
    const bool isPeak = p.z > 0.99 && std::abs(p.x - 0.5) < 0.01 && std::abs(p.y - 0.5) < 0.01;
    return Vector3{ p.x + (1 - p.z) / 12, p.y + (1 - p.z) / 12, isPeak ? 0.04 : 0.4 * p.z };
  };
  Ground ground({ 6, 6, 1, peak }, {}, ZHigh);
  ground.limit(0.3);
  const double edge = 1.0 / 12;
  int highest = 0;
  for (const auto& [x, y] : { std::pair(0.5 - edge, 0.5 - edge), std::pair(0.5 + edge, 0.5 + edge) })
  {
    highest = std::max(highest, ground.at(x, y).levels);
    EXPECT_EQ(ground.at(x, y).reason, StopReason::Gap);
  }
  EXPECT_LE(highest, 1); // 0.3 of 0.04 in steps of 0.01
}

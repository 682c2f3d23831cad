#include "Layers/ColumnLimits.h"

#include "Layers/ColumnBuilder.h"
#include "Mesh/Builder.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace ransmesh;
using namespace grid_mesh;

namespace
{
// A channel of the given height between two walls, with columns on the lower one.
struct Channel
{
  TetMesh mesh;
  LayerPlan plan;
  ColumnSet set;

  explicit Channel(double height, int cells = 3)
    : plan(7)
  {
    const auto map = [height](const Vector3& p) { return Vector3{ p.x, p.y, height * p.z }; };
    EXPECT_TRUE(buildTetMesh(make({ 6, 6, cells, map }), mesh).ok());
    plan[ZLow].firstHeight = 0.01;
    plan[ZLow].growthRate = 1;
    plan[ZLow].numberOfLayers = 20;
    set = buildColumns(mesh, BoundaryStars(mesh), patches(PatchType::Symmetry), plan);
  }
  const Column& middle() const
  {
    for (const Column& c : set.columns)
    {
      if (distance(c.base, { 0.5, 0.5, 0 }) < 1e-12)
      {
        return c;
      }
    }
    throw std::logic_error("no column in the middle");
  }
};
} // namespace

TEST(ColumnLimits, LevelBelowIsTheHighestThatFits)
{
  const Channel channel(1);
  EXPECT_EQ(levelBelow(channel.set, channel.middle(), 0.0999), 9);
  EXPECT_EQ(levelBelow(channel.set, channel.middle(), 0.1001), 10);
  const double height = channel.set.heightsOf(channel.middle()).height(7);
  EXPECT_EQ(levelBelow(channel.set, channel.middle(), height), 7);
  EXPECT_EQ(levelBelow(channel.set, channel.middle(), 5), 20);
  EXPECT_EQ(levelBelow(channel.set, channel.middle(), 0.001), 0);
}

TEST(ColumnLimits, AColumnWithLittleMissingKeepsAllItsLayers)
{
  Channel channel(1);
  Column& c = channel.set.columns.front();
  for (const double height : { 0.195, 0.18 })
  {
    limitHeight(channel.set, c, height, StopReason::Gap);
    EXPECT_EQ(c.levels, 20);
    EXPECT_EQ(c.reason, StopReason::Complete);
    EXPECT_NEAR(channel.set.thickness(c), height, 1e-12);
    EXPECT_NEAR(distance(channel.set.pointAt(c, 1), c.base), 0.01 * norm(c.direction), 1e-12);
  }
  EXPECT_NEAR(channel.set.thickness(channel.middle()), 0.2, 1e-12);
  limitHeight(channel.set, c, 0.1, StopReason::Gap);
  EXPECT_EQ(c.reason, StopReason::Gap);
  EXPECT_EQ(c.levels, levelBelow(channel.set, c, 0.1));
  EXPECT_LT(c.levels, 13);
}

TEST(ColumnLimits, OfColumnsThatShareTheirHeightsOneIsLoweredAlone)
{
  Channel channel(1);
  Column& c = channel.set.columns.front();
  limitHeight(channel.set, c, 0.195, StopReason::Gap);
  Column& other = channel.set.columns.back(); // as in a fan
  other.squeezed = c.squeezed;
  limitHeight(channel.set, other, 0.18, StopReason::Corner);
  EXPECT_NEAR(channel.set.thickness(other), 0.18, 1e-12);
  EXPECT_NEAR(channel.set.thickness(c), 0.195, 1e-12);
}

TEST(ColumnLimits, OfAColumnThatMissesLayersTheRestKeepTheirHeights)
{
  Channel channel(1);
  Column& c = channel.set.columns.front();
  limitHeight(channel.set, c, 0.1001, StopReason::Gap);
  EXPECT_EQ(c.levels, 10);
  limitHeight(channel.set, c, 0.0999, StopReason::Transition);
  EXPECT_EQ(c.levels, 9);
  EXPECT_EQ(c.reason, StopReason::Transition);
  EXPECT_NEAR(channel.set.thickness(c), 0.09, 1e-12);
}

TEST(ColumnLimits, ColumnsOfGridsAreNotSqueezed)
{
  Channel channel(1);
  Column& c = channel.set.columns.front();
  c.hasGrid = true;
  limitHeight(channel.set, c, 0.1999, StopReason::Gap);
  EXPECT_EQ(c.levels, 19);
  EXPECT_EQ(c.reason, StopReason::Gap);
}

TEST(ColumnLimits, NoSpacingAboveThePartOfTheIsotropicSize)
{
  Channel channel(1);
  channel.plan[ZLow].growthRate = 1.5;
  channel.set =
    buildColumns(channel.mesh, BoundaryStars(channel.mesh), patches(PatchType::Symmetry), channel.plan);
  limitByIsotropicSize(channel.plan, channel.set);
  const Column& c = channel.middle();
  EXPECT_EQ(c.reason, StopReason::IsotropicSize);
  const LayerHeights& heights = channel.set.heightsOf(c);
  const auto sizeAt = [&](int level) { return c.size + IsotropicGrowth * heights.height(level); };
  EXPECT_LE(heights.spacing(c.levels), 0.7 * sizeAt(c.levels));
  EXPECT_GT(heights.spacing(c.levels + 1), 0.7 * sizeAt(c.levels + 1));
}

TEST(ColumnLimits, LevelsRiseAgainOverEdgesShorterThanALayerIsHigh)
{
  Channel channel(1);
  channel.plan[ZLow].firstHeight = 0.2;
  channel.plan[ZLow].growthRate = 1;
  channel.plan[ZLow].numberOfLayers = 3;
  channel.set =
    buildColumns(channel.mesh, BoundaryStars(channel.mesh), patches(PatchType::Symmetry), channel.plan);
  Column& first = channel.set.columns.front();
  first.limit(1, StopReason::Corner);
  limitBySlope(channel.mesh, BoundaryStars(channel.mesh), channel.set);
  for (const Column& c : channel.set.columns)
  {
    // Along the edges the way to the first column is at most the sum of the coordinates' differences.
    const double way = std::abs(c.base.x - first.base.x) + std::abs(c.base.y - first.base.y);
    const double rise = 0.7 / std::numbers::sqrt2 * way;
    EXPECT_GE(c.levels, std::min(3, static_cast<int>((0.2 + rise) / 0.2 + 1e-9)));
  }
}

TEST(ColumnLimits, NeighboursOfALowColumnStepDown)
{
  Channel channel(1);
  for (Column& c : channel.set.columns)
  {
    if (distance(c.base, { 0, 0, 0 }) < 1e-12)
    {
      c.limit(0, StopReason::Corner);
    }
  }
  limitBySlope(channel.mesh, BoundaryStars(channel.mesh), channel.set);
  for (const Column& c : channel.set.columns)
  {
    EXPECT_LE(channel.set.thickness(c), std::max(std::abs(c.base.x), std::abs(c.base.y)) * 1.42 + 1e-9);
    EXPECT_EQ(c.reason == StopReason::Transition, c.levels < 20 && c.levels > 0);
  }
  EXPECT_EQ(channel.middle().levels, 20);
}

namespace
{
// A floor whose half at x < 0.5 is a patch of its own, with 20 levels of 0.01 on the rest.
struct SplitFloor
{
  TetMesh mesh;
  LayerPlan plan;
  ColumnSet set;

  explicit SplitFloor(int layersOnHalf)
    : plan(8)
  {
    const auto split = [](Side side, const Vector3& middle)
    { return side == ZLow && middle.x < 0.5 ? 7 : static_cast<int>(side); };
    EXPECT_TRUE(buildTetMesh(make({ 20, 4, 4 }, split), mesh).ok());
    plan[ZLow].firstHeight = 0.01;
    plan[ZLow].growthRate = 1;
    plan[ZLow].numberOfLayers = 20;
    plan[7] = plan[ZLow];
    plan[7].firstHeight = 0.001;
    plan[7].numberOfLayers = layersOnHalf;
    set = buildColumns(mesh, BoundaryStars(mesh), patches(PatchType::Symmetry, 7), plan);
    limitBySlope(mesh, BoundaryStars(mesh), set);
  }

  // Heights fall towards the border, from all 20 levels to the height there.
  void expectRamp(double atBorder) const
  {
    for (const Column& c : set.columns)
    {
      if (c.patch == ZLow)
      {
        const double thickness = set.thickness(c);
        const double allowed = atBorder + 0.7 * (c.base.x - 0.5) + 1e-12;
        EXPECT_LE(thickness, allowed);
        EXPECT_GT(thickness, std::min(0.2, allowed) - 0.04) << c.base.x; // a level for each edge of the way
        EXPECT_EQ(c.reason, c.levels < 20 ? StopReason::Transition : StopReason::Complete);
      }
    }
  }
};
} // namespace

TEST(ColumnLimits, ATallWallStepsDownToALowOne)
{
  SplitFloor(10).expectRamp(0.01);
}

TEST(ColumnLimits, ATallWallStepsDownToItsEnd)
{
  SplitFloor(0).expectRamp(0.7 * 0.05);
}

TEST(ColumnLimits, ACornerIsLimitedByTheIsotropicSizeOfBothWalls)
{
  TetMesh mesh;
  ASSERT_TRUE(buildTetMesh(make({ 6, 6, 6 }), mesh).ok());
  for (const int coarse : { XLow, ZLow })
  {
    LayerPlan plan(7);
    for (const int wall : { XLow, ZLow })
    {
      plan[wall].firstHeight = wall == coarse ? 0.002 : 0.001;
      plan[wall].growthRate = wall == coarse ? 1.8 : 1.05;
      plan[wall].numberOfLayers = 20;
    }
    ColumnSet set = buildColumns(mesh, BoundaryStars(mesh), patches(PatchType::Symmetry), plan);
    ASSERT_EQ(set.corners.size(), 7U);
    limitByIsotropicSize(plan, set);
    for (const TensorCorner& corner : set.corners)
    {
      const Column& c = set.columns[corner.column];
      EXPECT_EQ(c.levels, levelsOfIsotropicSize(set.heights[coarse], plan[coarse].isotropicFraction, c.size));
      EXPECT_EQ(c.reason, StopReason::IsotropicSize);
    }
  }
}

TEST(ColumnLimits, AHighWallIsNotLoweredByACornerThatIsAsHighOverIt)
{
  TetMesh mesh;
  ASSERT_TRUE(buildTetMesh(make({ 12, 4, 12 }), mesh).ok());
  LayerPlan plan(7);
  plan[XLow].firstHeight = 0.03;
  plan[ZLow].firstHeight = 0.003;
  for (const int wall : { XLow, ZLow })
  {
    plan[wall].growthRate = 1;
    plan[wall].numberOfLayers = 10;
  }
  ColumnSet set = buildColumns(mesh, BoundaryStars(mesh), patches(PatchType::Symmetry), plan);
  ASSERT_EQ(set.bends.size(), 5U);
  limitBySlope(mesh, BoundaryStars(mesh), set);
  for (const Column& c : set.columns)
  {
    EXPECT_EQ(c.levels, 10) << c.base.x << ' ' << c.base.z;
  }
}

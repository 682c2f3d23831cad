#include "Insertion/EnrichmentChecks.h"

#include "Boundary/Sheets.h"
#include "Insertion/FrontRaising.h"
#include "Insertion/TensorStacks.h"
#include "Layers/ColumnBuilder.h"
#include "Mesh/Builder.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace ransmesh;
using namespace grid_mesh;
using namespace enrichment_checks;

namespace
{
// Columns and points of a box of n x n x n cells with k layers on some walls, all complete.
struct Counts
{
  std::size_t columns;
  std::size_t ridgePoints;
  std::size_t triplePoints;
};

void expectGrids(const EnrichedMesh& enriched, const Counts& counts, std::size_t k)
{
  EXPECT_EQ(enriched.report.columns, counts.columns);
  const std::size_t inRidgeGrid = (k + 1) * (k + 1) - (k + 1);
  const std::size_t inTripleGrid = (k + 1) * (k + 1) * (k + 1) - (k + 1);
  EXPECT_EQ(enriched.report.pointsRequested,
    counts.columns * k + counts.ridgePoints * inRidgeGrid + counts.triplePoints * inTripleGrid);
  EXPECT_EQ(enriched.report.pointsInserted, enriched.report.pointsRequested);
  EXPECT_EQ(enriched.report.grids.planned, counts.ridgePoints + counts.triplePoints);
  EXPECT_EQ(enriched.report.grids.made, enriched.report.grids.planned);
}

bool hasPoint(const EnrichedMesh& enriched, const Vector3& x)
{
  return std::any_of(enriched.mesh.points.begin(), enriched.mesh.points.end(),
    [&x](const Vector3& p) { return distance(p, x) < 1e-13; });
}
} // namespace

TEST(TensorCorners, TwoWallsMakeAGridAlongTheirRidge)
{
  const MeshData mesh = make({ 5, 5, 5 });
  PatchTable table = patches(PatchType::Symmetry);
  const auto enriched = enrichAndCheck(mesh, table, planFor(7, { XLow, ZLow }, 1e-4, 8));
  expectGrids(enriched, { 2 * 36 - 6, 6, 0 }, 8);
  const LayerHeights heights(planFor(7, { ZLow }, 1e-4, 8)[ZLow]);
  for (const int i : { 0, 1, 5, 8 })
  {
    for (const int j : { 0, 1, 5, 8 })
    {
      EXPECT_TRUE(hasPoint(enriched, { heights.height(i), 0.4, heights.height(j) })) << i << ' ' << j;
    }
  }
}

TEST(TensorCorners, ThreeWallsMakeACube)
{
  const MeshData mesh = make({ 4, 4, 4 });
  const auto enriched =
    enrichAndCheck(mesh, patches(PatchType::Symmetry), planFor(7, { XLow, YLow, ZLow }, 1e-4, 6));
  expectGrids(enriched, { 3 * 25 - 3 * 5 + 1, 3 * 4, 1 }, 6);
  const LayerHeights heights(planFor(7, { ZLow }, 1e-4, 6)[ZLow]);
  EXPECT_TRUE(hasPoint(enriched, { heights.height(2), heights.height(6), heights.height(3) }));
  EXPECT_TRUE(hasPoint(enriched, { 0, heights.height(1), heights.height(5) }));
}

TEST(TensorCorners, SkewWallsHaveParallelograms)
{
  const auto skew = [](const Vector3& p) { return Vector3{ p.x + 0.3 * p.z, p.y, p.z }; };
  const MeshData mesh = make({ 5, 5, 5, skew });
  for (const std::set<int>& walls : { std::set<int>{ XLow, ZLow }, { XHigh, ZLow }, { XLow, YLow, ZLow } })
  {
    const auto enriched = enrichAndCheck(mesh, patches(PatchType::Symmetry), planFor(7, walls, 1e-4, 8));
    EXPECT_EQ(enriched.report.pointsInserted, enriched.report.pointsRequested);
    EXPECT_GT(enriched.mesh.points.size(), mesh.points.size() + enriched.report.columns * 8);
  }
}

// Two walls enclose 61 degrees, then 57: there the columns between all three would lean by 33.
TEST(TensorCorners, BetweenThreeWallsColumnsLeanByThirtyDegreesAtMost)
{
  const auto planned = [](double lean)
  {
    const auto skew = [lean](const Vector3& p) { return Vector3{ p.x + lean * p.z, p.y, p.z }; };
    const auto enriched = enrichAndCheck(
      make({ 5, 5, 5, skew }), patches(PatchType::Symmetry), planFor(7, { XLow, YLow, ZLow }, 1e-4, 8));
    EXPECT_EQ(enriched.report.pointsInserted, enriched.report.pointsRequested);
    return enriched.report.grids.planned;
  };
  EXPECT_EQ(planned(0.55), planned(0.65) + 1);
}

TEST(TensorCorners, WideCornersHaveOneColumn)
{
  // The walls enclose 60 degrees on one side of the box and 120 on the other.
  const auto skew = [](const Vector3& p) { return Vector3{ p.x + 0.577 * p.z, p.y, p.z }; };
  const MeshData mesh = make({ 5, 5, 5, skew });
  std::size_t narrow = 0;
  for (const int wall : { XLow, XHigh })
  {
    const auto enriched =
      enrichAndCheck(mesh, patches(PatchType::Symmetry), planFor(7, { wall, ZLow }, 1e-4, 8));
    EXPECT_EQ(enriched.report.pointsInserted, enriched.report.pointsRequested);
    const bool hasGrid = enriched.mesh.points.size() > mesh.points.size() + enriched.report.columns * 8;
    EXPECT_EQ(hasGrid, enriched.report.grids.made > 0);
    narrow += hasGrid;
  }
  EXPECT_EQ(narrow, 1U);
}

TEST(TensorCorners, AColumnThatIsCutShortHasNoGrid)
{
  // Levels that the isotropic size forbids: all columns are short.
  LayerPlan plan = planFor(7, { XLow, ZLow }, 1e-2, 12);
  const auto enriched = enrichAndCheck(make({ 8, 8, 8 }), patches(PatchType::Symmetry), plan);
  const auto isShort = [](const WallPoint& p) { return p.layersAchieved < p.layersAsked; };
  ASSERT_TRUE(std::all_of(enriched.wallPoints.begin(), enriched.wallPoints.end(), isShort));
  EXPECT_EQ(enriched.report.grids.planned, 0U);
  EXPECT_EQ(enriched.wallPoints.size(), enriched.report.columns);
}

TEST(TensorCorners, NewPointsOfTheWallsAreReported)
{
  const auto enriched =
    enrichAndCheck(make({ 4, 4, 4 }), patches(PatchType::Symmetry), planFor(7, { XLow, ZLow }, 1e-4, 5));
  std::set<Index> onWall;
  for (std::size_t i = 0; i < enriched.mesh.triangles.size(); ++i)
  {
    const int patch = enriched.mesh.trianglePatch[i];
    if (patch == XLow || patch == ZLow)
    {
      onWall.insert(enriched.mesh.triangles[i].begin(), enriched.mesh.triangles[i].end());
    }
  }
  std::set<Index> reported;
  for (const WallPoint& point : enriched.wallPoints)
  {
    EXPECT_TRUE(reported.insert(point.point).second);
  }
  EXPECT_EQ(reported, onWall);
  EXPECT_EQ(onWall.size(), 2 * 25 - 5 + 2u * 5u * 5u);
}

TEST(TensorCorners, WhereAWallChangesItsLayersThereIsNoGrid)
{
  const auto split = [](Side side, const Vector3& middle)
  { return side == ZLow && middle.y < 0.5 ? 7 : static_cast<int>(side); };
  LayerPlan plan = planFor(8, { XLow, ZLow, 7 }, 1e-4, 8);
  plan[7].growthRate = 1.1;
  const auto enriched = enrichAndCheck(make({ 4, 4, 4 }, split), patches(PatchType::Symmetry, 7), plan);
  EXPECT_EQ(enriched.report.grids.planned, 4u); // of five ridge points
  EXPECT_EQ(enriched.report.grids.made, 4u);
}

TEST(TensorCorners, WallsKeepTheirOwnHeights)
{
  LayerPlan plan = planFor(7, { XLow, ZLow }, 1e-4, 8);
  plan[XLow].firstHeight = 3e-3;
  plan[XLow].growthRate = 1.1;
  const auto enriched = enrichAndCheck(make({ 5, 5, 5 }), patches(PatchType::Symmetry), plan);
  expectGrids(enriched, { 2 * 36 - 6, 6, 0 }, 8);
  const LayerHeights overX(plan[XLow]);
  const LayerHeights overZ(plan[ZLow]);
  for (const int i : { 0, 1, 5, 8 })
  {
    for (const int j : { 0, 1, 5, 8 })
    {
      EXPECT_TRUE(hasPoint(enriched, { overX.height(i), 0.4, overZ.height(j) })) << i << ' ' << j;
    }
  }
  for (const WallPoint& point : enriched.wallPoints)
  {
    EXPECT_EQ(point.layersAchieved, point.layersAsked);
    EXPECT_NEAR(point.firstHeightAchieved, point.firstHeightAsked, 1e-12);
  }
}

TEST(TensorCorners, AHighWallsLayersLeanOverAFloorOfHigherColumns)
{
  // The corner's last level lies 0.067 from the wall and 0.02 above the floor, whose own columns are 0.05 high.
  for (const int wall : { XLow, XHigh })
  {
    LayerPlan plan = planFor(7, { wall, ZLow }, 1.06e-4, 25);
    plan[wall].growthRate = 1.3;
    plan[wall].numberOfLayers = 20;
    const auto enriched = enrichAndCheck(make({ 7, 4, 7 }), patches(PatchType::Symmetry), plan);
    EXPECT_EQ(
      enriched.report.columnsByReason[static_cast<int>(StopReason::Complete)], enriched.report.columns);
    EXPECT_EQ(enriched.report.grids.made, 5U);
    EXPECT_EQ(enriched.report.pointsInserted, enriched.report.pointsRequested);
  }
}

TEST(TensorCorners, ACornerHasTheLayersThatBothWallsHave)
{
  LayerPlan plan = planFor(7, { XLow, YLow, ZLow }, 1e-4, 8);
  plan[XLow].numberOfLayers = 5;
  plan[YLow].firstHeight = 2e-4;
  const auto enriched = enrichAndCheck(make({ 5, 5, 5 }), patches(PatchType::Symmetry), plan);
  EXPECT_EQ(enriched.report.pointsInserted, enriched.report.pointsRequested);
  EXPECT_EQ(enriched.report.grids.made, enriched.report.grids.planned);
  const LayerHeights overX(plan[XLow]);
  const LayerHeights overY(plan[YLow]);
  const LayerHeights overZ(plan[ZLow]);
  EXPECT_TRUE(hasPoint(enriched, { overX.height(5), 0.4, overZ.height(5) }));
  EXPECT_FALSE(hasPoint(enriched, { overX.height(5), 0.4, overZ.height(6) }));
  EXPECT_TRUE(hasPoint(enriched, { 0.4, overY.height(8), overZ.height(8) }));
  EXPECT_TRUE(hasPoint(enriched, { overX.height(3), overY.height(2), overZ.height(5) }));
}

TEST(TensorCorners, LayersTooThickForTheGridKeepTheirColumns)
{
  // Thicker than the first row of wall points is far from the ridge.
  const auto enriched =
    enrichAndCheck(make({ 8, 8, 8 }), patches(PatchType::Symmetry), planFor(7, { XLow, ZLow }, 8e-3, 10));
  EXPECT_GT(enriched.report.pointsInserted, enriched.report.columns);
}

namespace
{
// A box with walls at x = 0 and z = 0 whose columns stand at their full height, whatever is beyond.
struct Raised
{
  TetMesh mesh;
  ColumnSet set;
  std::vector<BaseFace> faces;
  std::vector<Vector3> points; // of the mesh before, then of the columns
  std::vector<Index> baseNumber;

  Raised(const MeshData& data, double firstHeight)
  {
    EXPECT_TRUE(buildTetMesh(data, mesh).ok());
    set = buildColumns(
      mesh, BoundaryStars(mesh), patches(PatchType::Symmetry), planFor(7, { XLow, ZLow }, firstHeight, 10));
    points = data.points;
    for (std::size_t v = 0; v < points.size(); ++v)
    {
      baseNumber.push_back(static_cast<Index>(v));
    }
    for (const Column& c : set.columns)
    {
      for (int level = 1; level <= c.levels; ++level)
      {
        points.push_back(set.pointAt(c, level));
      }
      mesh.movePoint(c.vertex, set.pointAt(c, c.levels));
    }
    faces = collectBaseFaces(mesh, set);
    findSides(mesh, set, faces);
  }

  GridReport grids(double maximumSurfaceAngle) const
  {
    const ColumnPoints numbers(set, baseNumber, baseNumber.size());
    return makeTensorStacks(mesh, set, faces, numbers, baseNumber, points, maximumSurfaceAngle).report;
  }
};

// The floor's slope along x changes from one row of points to the next.
MeshData twistedBox(double slope)
{
  return make({ 5, 3, 5, [slope](const Vector3& p) {
                 return Vector3{ p.x, p.y, p.z + slope * p.x * (1 - p.z) * std::cos(3 * M_PI * p.y) };
               } });
}
} // namespace

TEST(TensorCorners, GridsDoNotTurnTheirWallsTooFar)
{
  const Raised box(twistedBox(0.02), 1e-5);
  EXPECT_EQ(box.grids(10).planned, 4u);
  EXPECT_EQ(box.grids(10).made, 4u);
  EXPECT_EQ(box.grids(0.01).made, 0u);
}

TEST(TensorCorners, GridsDoNotTakeTheirWallsTooFarOffTheirPlanes)
{
  const MeshData data = twistedBox(0.09);
  EXPECT_EQ(Raised(data, 1e-5).grids(60).made, 4u);
  EXPECT_EQ(Raised(data, 7e-3).grids(60).made, 0u); // as wide as nearly a row of triangles
}

TEST(TensorCorners, ACornerWhoseTopGotStuckHasNoGrid)
{
  Raised box(make({ 4, 4, 4 }), 1e-4);
  EXPECT_EQ(CornerChoice(box.mesh, box.set, box.faces).count(), 5u);
  const Column& stuck = box.set.columns[box.set.corners[2].column];
  box.mesh.movePoint(stuck.vertex, box.set.pointAtHeight(stuck, 0.9 * box.set.thickness(stuck)));
  const CornerChoice choice(box.mesh, box.set, box.faces);
  EXPECT_EQ(choice.count(), 4u);
  EXPECT_EQ(choice.report().planned, 5u);
  EXPECT_EQ(choice.report().lostPoints, 11u * 11u - 11u);
}

TEST(TensorCorners, ACornerWhoseTopCannotRiseToTheEndKeepsTheGridOfOneLevelLess)
{
  // A point that must not move stands in the way of one corner's column, just below its top.
  constexpr int Layers = 10;
  const LayerPlan plan = planFor(8, { XLow, ZLow }, 5e-3, Layers);
  const double thickness = LayerHeights(plan[ZLow]).height(Layers);
  MeshData data = make({ 4, 4, 4 });
  const int sheet = addSheet(data,
    [](const Vector3& middle)
    {
      return std::fabs(middle.x - 0.25) < 1e-9 && std::fabs(middle.y - 0.5) < 0.25 && middle.z > 0.25 &&
        middle.z < 0.5;
    });
  OpenedSheets opened;
  ASSERT_TRUE(openSheets(data, opened).ok());
  const auto obstacle = std::find_if(data.points.begin(), data.points.end(),
    [](const Vector3& p) {
      return distance(p, { 0.25, 0.5, 0.25 }) < 1e-12;
    });
  *obstacle = { 0.98 * thickness, 0.5, 0.98 * thickness };
  PatchTable table = patches(PatchType::Symmetry, sheet);
  table.back().type = PatchType::Interface;

  TetMesh mesh;
  ASSERT_TRUE(buildTetMesh(data, mesh).ok());
  ColumnSet set = buildColumns(mesh, BoundaryStars(mesh), table, plan);
  RaisingReport report;
  ASSERT_TRUE(raiseFront(mesh, set, classify(mesh, table), 10, Context(), report));
  EXPECT_GE(report.stuck, 1U); // a neighbour may be in its way too
  const auto isShort = [](const Column& c) { return c.levels < c.asked; };
  const auto stuck = std::find_if(set.columns.begin(), set.columns.end(), isShort);
  ASSERT_NE(stuck, set.columns.end());
  EXPECT_EQ(stuck->levels, Layers - 1);
  EXPECT_EQ(mesh.point(stuck->vertex), set.pointAt(*stuck, stuck->levels));
  std::vector<BaseFace> faces = collectBaseFaces(mesh, set);
  findSides(mesh, set, faces);
  EXPECT_EQ(CornerChoice(mesh, set, faces).count(), 5U);
}

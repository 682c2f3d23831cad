#include "Insertion/EnrichmentChecks.h"

#include "Support/GridMesh.h"

#include <gtest/gtest.h>

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

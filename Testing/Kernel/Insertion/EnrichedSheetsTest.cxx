// Layers on sheets: cut open, enriched, put together again.
#include "Insertion/EnrichedSheets.h"

#include "Insertion/EnrichmentChecks.h"
#include "Layers/LayerPlanning.h"
#include "Mesh/Builder.h"
#include "Mesh/Validation.h"
#include "Removal/PointRemoval.h"
#include "Support/GridMesh.h"
#include "Support/Invariants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace
{
using namespace ransmesh;

constexpr int Layers = 8;
constexpr double FirstHeight = 1e-4;

bool isAtHalf(double x)
{
  return std::fabs(x - 0.5) < 1e-9;
}

class EnrichedSheets : public testing::Test
{
protected:
  void SetUp() override { patches_[7] = { "sheet", PatchType::Wake }; }

  // Runs removal and enrichment across the sheets of mesh_, and checks what must hold afterwards.
  EnrichedMesh run(const LayerPlan& plan)
  {
    MeshData mesh = mesh_;
    OpenedSheets opened;
    EXPECT_TRUE(openSheets(mesh, opened).ok());
    const PatchTable seen = patchesOfOpened(patches_, opened.patches, plan);
    EnrichedMesh enriched;
    const Outcome outcome = enrich(mesh, seen, plan, {}, {}, enriched);
    EXPECT_TRUE(outcome.ok()) << outcome.message;
    EXPECT_TRUE(closeSheets(opened, enriched).ok());
    invariants::expectKept(mesh_, enriched.mesh, 1e-9);
    EXPECT_EQ(enriched.column.size(), enriched.mesh.points.size());
    EXPECT_EQ(enriched.origin.size(), enriched.mesh.points.size());
    for (const Index v : enriched.origin)
    {
      EXPECT_LT(v, static_cast<Index>(mesh_.points.size()));
    }
    return enriched;
  }

  // How many points of the sheet inside the box (grown by 1e-9) have complete columns on both
  // sides.
  static int fullPoints(const EnrichedMesh& enriched, const Vector3& low, const Vector3& high)
  {
    std::map<Index, int> columns;
    for (const WallPoint& point : enriched.wallPoints)
    {
      columns[point.point] += point.patch == 7 && point.layersAchieved == Layers;
    }
    int full = 0;
    for (const auto& [point, count] : columns)
    {
      const Vector3& p = enriched.mesh.points[point];
      bool inside = true;
      for (int axis = 0; axis < 3; ++axis)
      {
        inside = inside && p[axis] > low[axis] - 1e-9 && p[axis] < high[axis] + 1e-9;
      }
      full += inside && count >= 2;
    }
    return full;
  }

  MeshData mesh_ = grid_mesh::make({ 6, 6, 6 });
  PatchTable patches_ = grid_mesh::patches(PatchType::FarField, 7);
};

TEST_F(EnrichedSheets, AFreeSheetHasColumnsOnBothSides)
{
  grid_mesh::addSheet(mesh_,
    [](const Vector3& p) { return isAtHalf(p.z) && p.x > 0.17 && p.x < 0.83 && p.y > 0.17 && p.y < 0.83; });
  const EnrichedMesh enriched = run(enrichment_checks::planFor(8, { 7 }, FirstHeight, Layers));
  // Inside the sheet, where two edges that cut off corners were divided.
  EXPECT_EQ(fullPoints(enriched, { 0.2, 0.2, 0 }, { 0.8, 0.8, 1 }), 9 + 2);
  EXPECT_GE(enriched.report.pointsInserted, 2u * 11u * Layers);
}

TEST_F(EnrichedSheets, ASheetFromSideToSideHasThemInTheSides)
{
  patches_[3].type = PatchType::Symmetry;
  patches_[4].type = PatchType::Symmetry;
  grid_mesh::addSheet(mesh_, [](const Vector3& p) { return isAtHalf(p.z) && p.x > 0.34; });
  const EnrichedMesh enriched = run(enrichment_checks::planFor(8, { 7 }, FirstHeight, Layers));
  EXPECT_EQ(fullPoints(enriched, { 0.5, 0, 0 }, { 1, 1, 1 }), 4 * 7);
}

TEST_F(EnrichedSheets, ASheetThatSplitsTheDomainIsFull)
{
  grid_mesh::addSheet(mesh_, [](const Vector3& p) { return isAtHalf(p.z); });
  const EnrichedMesh enriched = run(enrichment_checks::planFor(8, { 7 }, FirstHeight, Layers));
  EXPECT_EQ(fullPoints(enriched, { 0, 0, 0 }, { 1, 1, 1 }), 49);
  EXPECT_EQ(enriched.report.pointsInserted, 2u * 49u * Layers);
}

TEST_F(EnrichedSheets, AFinAndItsFloorHaveLayers)
{
  patches_[5].type = PatchType::Wall;
  grid_mesh::addSheet(
    mesh_, [](const Vector3& p) { return isAtHalf(p.x) && p.z < 0.5 && p.y > 0.17 && p.y < 0.83; });
  const EnrichedMesh enriched = run(enrichment_checks::planFor(8, { 5, 7 }, FirstHeight, Layers));
  EXPECT_GE(fullPoints(enriched, { 0, 0.2, 0.1 }, { 1, 0.8, 0.4 }), 3 * 2);
}

TEST_F(EnrichedSheets, ASheetWithoutLayersIsFrozen)
{
  patches_[5].type = PatchType::Wall;
  grid_mesh::addSheet(mesh_, [](const Vector3& p) { return isAtHalf(p.x) && p.z < 0.5; });
  const EnrichedMesh enriched = run(enrichment_checks::planFor(8, { 5 }, FirstHeight, Layers));
  std::size_t frozen = 0;
  for (const WallPoint& point : enriched.wallPoints)
  {
    EXPECT_EQ(point.patch, 5);
    frozen += point.reason == StopReason::Frozen;
  }
  EXPECT_EQ(frozen, 2u * 7u);
}

TEST_F(EnrichedSheets, RemovalKeepsBothSidesAlike)
{
  // Layers as thick as the cells: their region holds points on both sides, and of the symmetry.
  mesh_ = grid_mesh::make({ 9, 9, 9 });
  patches_[3].type = PatchType::Symmetry;
  for (const bool hasLayers : { true, false })
  {
    MeshData mesh = mesh_;
    grid_mesh::addSheet(mesh, [](const Vector3& p) { return std::fabs(p.z - 4.0 / 9) < 1e-9 && p.x > 0.34; });
    const MeshData before = mesh;
    const LayerPlan plan = hasLayers ? enrichment_checks::planFor(8, { 7 }, 0.02, 5)
                                     : enrichment_checks::planFor(8, { 5 }, 0.03, 5);
    OpenedSheets opened;
    ASSERT_TRUE(openSheets(mesh, opened).ok());
    TetMesh built = invariants::build(mesh);
    const RemovalResult result =
      removePoints(built, patchesOfOpened(patches_, opened.patches, plan), plan, {}, {});
    ASSERT_TRUE(result.outcome.ok()) << result.outcome.message;
    EXPECT_GT(result.removed, 100u);
    MeshData after = toMeshData(built);
    std::vector<Index> number;
    const Outcome outcome = closeSheets(after, opened.patches, number);
    ASSERT_TRUE(outcome.ok()) << outcome.message;
    invariants::expectKept(before, after);
  }
}
} // namespace

// Layers on sheets: cut open, enriched, put together again.
#include "Insertion/EnrichedSheets.h"

#include "Boundary/SheetFit.h"
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
    const Outcome outcome = enrichOpened(mesh, opened, seen, plan, {}, {}, enriched);
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

  // Removes points from a mesh that is cut open along its sheets, and puts it together again.
  void expectRemovalKeeps(const MeshData& before, const LayerPlan& plan)
  {
    MeshData mesh = before;
    OpenedSheets opened;
    ASSERT_TRUE(openSheets(mesh, opened).ok());
    TetMesh built = invariants::build(mesh);
    const RemovalResult result =
      removePoints(built, withFrozenSheets(patches_, opened.patches), plan, {}, {});
    ASSERT_TRUE(result.outcome.ok()) << result.outcome.message;
    EXPECT_GT(result.removed, 100u);
    MeshData after = toMeshData(built);
    std::vector<Index> number;
    const Outcome outcome = closeSheets(after, opened.patches, number);
    ASSERT_TRUE(outcome.ok()) << outcome.message;
    invariants::expectKept(before, after);
  }

  // A fin on the floor of a box that lies along no axis, sheared.
  void makeSkewFin(double shear)
  {
    patches_[5].type = PatchType::Wall;
    mesh_ = grid_mesh::make({ 6, 6, 6 });
    grid_mesh::addSheet(
      mesh_, [](const Vector3& p) { return isAtHalf(p.x) && p.z < 0.5 && p.y > 0.17 && p.y < 0.83; });
    for (Vector3& p : mesh_.points)
    {
      p = grid_mesh::turned({ p.x + shear * p.z, p.y, p.z });
    }
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

TEST_F(EnrichedSheets, PartsOfASheetMayTouchInSinglePoints)
{
  // Like the black fields of a chess board.
  mesh_ = grid_mesh::make({ 8, 8, 8 });
  grid_mesh::addSheet(mesh_,
    [](const Vector3& p)
    {
      const bool isBlack = (static_cast<int>(8 * p.x) + static_cast<int>(8 * p.y)) % 2 == 0;
      return isAtHalf(p.z) && isBlack && p.x > 0.2 && p.x < 0.8 && p.y > 0.2 && p.y < 0.8;
    });
  const EnrichedMesh enriched = run(enrichment_checks::planFor(8, { 7 }, FirstHeight, Layers));
  EXPECT_GT(enriched.report.pointsInserted, 0u);
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

TEST_F(EnrichedSheets, BothSidesOfAFinAreDividedAlike)
{
  for (const double shear : { 0.0, 0.3, -0.6, 1.5 })
  {
    makeSkewFin(shear);
    const LayerPlan plan = enrichment_checks::planFor(8, { 5, 7 }, FirstHeight, Layers);
    const EnrichedMesh enriched = run(plan);
    EXPECT_GT(enriched.report.pointsInserted, 0u);
  }
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

TEST_F(EnrichedSheets, RemovalKeepsAFinThatStandsInTheFloorsLayers)
{
  patches_[5].type = PatchType::Wall;
  for (const double height : { 0.5, 0.1, 0.2 }) // low ones have edges from their foot to their free border
  {
    mesh_ = grid_mesh::make({ 12, 12, 12 });
    grid_mesh::addSheet(mesh_,
      [height](const Vector3& p) { return isAtHalf(p.x) && p.z < height && p.y > 0.25 && p.y < 0.75; });
    expectRemovalKeeps(mesh_, enrichment_checks::planFor(8, { 5, 7 }, 0.02, 5));
  }
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
    const LayerPlan plan = hasLayers ? enrichment_checks::planFor(8, { 7 }, 0.02, 5)
                                     : enrichment_checks::planFor(8, { 5 }, 0.03, 5);
    expectRemovalKeeps(mesh, plan);
  }
}

// Sheets on whose sides new points came.
class SheetFitting : public testing::Test
{
protected:
  void SetUp() override
  {
    mesh_ = grid_mesh::make({ 2, 2, 2 });
    grid_mesh::addSheet(mesh_, [](const Vector3& p) { return isAtHalf(p.z); });
    ASSERT_TRUE(openSheets(mesh_, opened_).ok());
  }

  // Divides the first triangle of that side by a point in its middle, which stands a little aside.
  void divide(bool above, double aside)
  {
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i)
    {
      const auto v = mesh_.triangles[i];
      const Vector3 middle = (1.0 / 3) * (mesh_.points[v[0]] + mesh_.points[v[1]] + mesh_.points[v[2]]);
      const bool isAbove =
        cross(mesh_.points[v[1]] - mesh_.points[v[0]], mesh_.points[v[2]] - mesh_.points[v[0]]).z < 0;
      if (mesh_.trianglePatch[i] != 7 || isAbove != above || middle.x > 0.4 || middle.y > middle.x)
      {
        continue;
      }
      const auto point = static_cast<Index>(mesh_.points.size());
      mesh_.points.push_back(middle + Vector3{ aside, 0, 0 });
      mesh_.triangles[i] = { v[0], v[1], point };
      mesh_.triangles.push_back({ v[1], v[2], point });
      mesh_.triangles.push_back({ v[2], v[0], point });
      mesh_.trianglePatch.insert(mesh_.trianglePatch.end(), 2, 7);
      return;
    }
    FAIL() << "no triangle";
  }

  MeshData mesh_;
  OpenedSheets opened_;
};

TEST_F(SheetFitting, EqualSidesStayAsTheyAre)
{
  const auto points = mesh_.points;
  EXPECT_TRUE(fitSheets(mesh_, opened_.patches));
  EXPECT_EQ(mesh_.points, points);
}

TEST_F(SheetFitting, NewPointsOfTheSecondSideMoveOntoThoseOfTheFirst)
{
  divide(true, 0);
  divide(false, 1e-3);
  EXPECT_TRUE(fitSheets(mesh_, opened_.patches));
  EXPECT_TRUE(mesh_.points.back() == mesh_.points[mesh_.points.size() - 2]);
}

TEST_F(SheetFitting, SidesThatAreDividedDifferentlyDoNotFit)
{
  divide(true, 0);
  const auto points = mesh_.points;
  EXPECT_FALSE(fitSheets(mesh_, opened_.patches));
  EXPECT_EQ(mesh_.points, points);
}

TEST_F(SheetFitting, PointsFarApartAreNotTheSame)
{
  divide(true, 0);
  divide(false, 0.2);
  EXPECT_FALSE(fitSheets(mesh_, opened_.patches));
}
} // namespace

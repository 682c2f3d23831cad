#include "Removal/PointRemoval.h"

#include "Boundary/Classification.h"
#include "Geometry/Angles.h"
#include "Improvement/LocalImprovement.h"
#include "Support/GridMesh.h"
#include "Support/Invariants.h"
#include "Support/WallStar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace
{
using namespace ransmesh;
using grid_mesh::XHigh;
using grid_mesh::XLow;
using grid_mesh::ZHigh;
using grid_mesh::ZLow;

LayerPlan planWith(double thickness, const std::set<int>& walls)
{
  LayerPlan plan(7);
  for (const int wall : walls)
  {
    plan[wall].firstHeight = thickness / 10;
    plan[wall].growthRate = 1;
    plan[wall].numberOfLayers = 10;
  }
  return plan;
}

// The triangles of a patch, each by its corners' places.
std::set<std::array<double, 9>> trianglesOf(const MeshData& mesh, int patch)
{
  std::set<std::array<double, 9>> found;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    if (mesh.trianglePatch[i] == patch)
    {
      auto t = mesh.triangles[i];
      std::sort(t.begin(), t.end(),
        [&](Index a, Index b)
        {
          const Vector3& p = mesh.points[a];
          const Vector3& q = mesh.points[b];
          return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
        });
      std::array<double, 9> places;
      for (int j = 0; j < 3; ++j)
      {
        for (int k = 0; k < 3; ++k)
        {
          places[3 * j + k] = mesh.points[t[j]][k];
        }
      }
      found.insert(places);
    }
  }
  return found;
}

double worstQuality(const TetMesh& mesh)
{
  double worst = 1;
  for (std::size_t t = 0; t < mesh.tetSlots(); ++t)
  {
    if (mesh.tet(static_cast<Index>(t)).isAlive())
    {
      worst = std::min(worst, qualityOf(mesh, static_cast<Index>(t)));
    }
  }
  return worst;
}

class PointRemoval : public testing::Test
{
protected:
  RemovalResult remove(const MeshData& data, const LayerPlan& plan, const Context& context = {})
  {
    before_ = data;
    mesh_ = invariants::build(data);
    RemovalResult result = removePoints(mesh_, patches_, plan, {}, context);
    invariants::expectValid(mesh_);
    after_ = toMeshData(mesh_);
    invariants::expectKept(before_, after_);
    EXPECT_EQ(result.removed + result.remaining.size(), result.marked);
    EXPECT_EQ(before_.points.size() - after_.points.size(), result.removed);
    return result;
  }

  PatchTable patches_ = grid_mesh::patches(PatchType::Symmetry);
  MeshData before_;
  TetMesh mesh_;
  MeshData after_;
};

TEST_F(PointRemoval, EmptiesTheRegionOverAPlate)
{
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    const RemovalResult result =
      remove(grid_mesh::make({ 12, 12, 12, {}, 0.2, seed }), planWith(0.2, { ZLow }));
    EXPECT_TRUE(result.outcome.ok());
    EXPECT_GT(result.marked, 300u);
    EXPECT_TRUE(result.remaining.empty()) << result.text();
    EXPECT_GT(worstQuality(mesh_), 0.02);
    EXPECT_EQ(trianglesOf(before_, ZLow), trianglesOf(after_, ZLow));
    for (const Vector3& p : after_.points)
    {
      EXPECT_TRUE(p.z == 0 || p.z > 0.2);
    }
  }
}

TEST_F(PointRemoval, WorksInAnyDirection)
{
  const RemovalResult result =
    remove(grid_mesh::make({ 10, 10, 10, grid_mesh::turned, 0.2 }), planWith(0.25, { ZLow }));
  EXPECT_GT(result.marked, 200u);
  EXPECT_LE(result.remaining.size() * 200, result.marked) << result.text();
  EXPECT_EQ(trianglesOf(before_, ZLow), trianglesOf(after_, ZLow));
}

TEST_F(PointRemoval, ClearsCornersBetweenWalls)
{
  const double thickness = 0.15;
  const RemovalResult result =
    remove(grid_mesh::make({ 10, 10, 10, {}, 0.2 }), planWith(thickness, { XLow, ZLow }));
  EXPECT_LE(result.remaining.size() * 200, result.marked) << result.text();
  EXPECT_GT(result.markedOnWalls, 20u);
  EXPECT_EQ(result.remainingOnWalls, 0u);
  EXPECT_EQ(result.neededByShape, 0u); // planes need none
  for (const Vector3& p : after_.points)
  {
    EXPECT_FALSE((p.x == 0 && p.z > 0 && p.z <= thickness) || (p.z == 0 && p.x > 0 && p.x <= thickness));
  }
}

TEST_F(PointRemoval, LeavesWallsAsTheyAreUnderThinLayers)
{
  const RemovalResult result =
    remove(grid_mesh::make({ 10, 10, 10, {}, 0.2 }), planWith(0.05, { XLow, ZLow }));
  EXPECT_EQ(result.markedOnWalls, 0u);
  EXPECT_EQ(trianglesOf(before_, XLow), trianglesOf(after_, XLow));
  EXPECT_EQ(trianglesOf(before_, ZLow), trianglesOf(after_, ZLow));
}

// The largest angle of the triangles of a patch.
double largestAngleOf(const MeshData& mesh, int patch)
{
  double largest = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const auto& t = mesh.triangles[i];
    if (mesh.trianglePatch[i] == patch)
    {
      largest = std::max(largest, largestAngle(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]));
    }
  }
  return largest;
}

TEST_F(PointRemoval, MakesRoomInCavitiesOfSixWalls)
{
  for (const double sizes : { 1.0, 2.0 })
  {
    const RemovalResult result = remove(
      grid_mesh::make({ 12, 12, 12, grid_mesh::turned, 0.2 }), planWith(sizes / 12, { 1, 2, 3, 4, 5, 6 }));
    EXPECT_LE(result.remaining.size() * 1000, result.marked) << result.text();
    EXPECT_GT(result.markedOnWalls, 200u);
    EXPECT_EQ(result.remainingOnWalls, 0u);
    for (int patch = 1; patch <= 6; ++patch)
    {
      EXPECT_LT(largestAngleOf(after_, patch), 150) << "patch " << patch;
    }
  }
}

TEST_F(PointRemoval, DoesNotTurnCurvedWallsTooFar)
{
  // The floor is a wave that meets the wall XLow: its points may only go where that does not flatten it.
  const auto wave = [](const Vector3& p) {
    return Vector3{ p.x, p.y, p.z + 0.05 * (1 - p.z) * std::sin(9 * p.y) };
  };
  const MeshData data = grid_mesh::make({ 12, 12, 12, wave, 0.1 });
  TetMesh mesh = invariants::build(data);
  const RemovalResult result = removePoints(mesh, patches_, planWith(0.2, { XLow, ZLow }), {}, {});
  invariants::expectValid(mesh);
  EXPECT_GT(result.markedOnWalls, 20u);
  EXPECT_GT(result.neededByShape, 0u); // the wave's crests
  EXPECT_LE((result.remaining.size() - result.neededByShape) * 1000, result.marked) << result.text();
  const auto areas = invariants::patchAreas(toMeshData(mesh));
  const auto before = invariants::patchAreas(data);
  EXPECT_NEAR(areas.at(ZLow), before.at(ZLow), 0.01 * before.at(ZLow)) << result.text();
}

TEST_F(PointRemoval, LeavesOnlyTheWallsInAGapThatLayersFill)
{
  const auto flat = [](const Vector3& p) { return Vector3{ p.x, p.y, 0.3 * p.z }; };
  const RemovalResult result =
    remove(grid_mesh::make({ 10, 10, 4, flat, 0.15 }), planWith(0.2, { ZLow, ZHigh }));
  EXPECT_LE(result.remaining.size() * 100, result.marked) << result.text();
}

TEST_F(PointRemoval, RemovesWhatNoWallPointSeesWhole)
{
  const RemovalResult result =
    remove(wall_star::meshOf(wall_star::cube(), { 0.4, 0.5, 0.6 }), planWith(2, { 1 }));
  EXPECT_EQ(result.marked, 1u);
  EXPECT_TRUE(result.remaining.empty()) << result.text();
}

TEST_F(PointRemoval, CountsThePointsThatTheSpaceBetweenWallsNeeds)
{
  const RemovalResult result =
    remove(wall_star::meshOf(wall_star::schoenhardt(), { 0, 0, 0.5 }), planWith(2, { 1 }));
  EXPECT_EQ(result.marked, 1u);
  EXPECT_EQ(result.remaining, std::vector<Index>{ 6 });
  EXPECT_EQ(result.neededByShape, 1u);
}

TEST_F(PointRemoval, KeepsInterfacesAsTheyAre)
{
  patches_[XLow].type = PatchType::Interface;
  patches_[XHigh].type = PatchType::Interface;
  const RemovalResult result = remove(grid_mesh::make({ 10, 10, 10, {}, 0.2 }), planWith(0.2, { ZLow }));
  EXPECT_GT(result.removed, 0u);
  EXPECT_EQ(trianglesOf(before_, XLow), trianglesOf(after_, XLow));
  EXPECT_EQ(trianglesOf(before_, XHigh), trianglesOf(after_, XHigh));
}

TEST_F(PointRemoval, DoesNothingForThinLayers)
{
  const RemovalResult result = remove(grid_mesh::make({ 10, 10, 10, {}, 0.1 }), planWith(1e-3, { ZLow }));
  EXPECT_TRUE(result.outcome.ok());
  EXPECT_EQ(result.marked, 0u);
  EXPECT_EQ(after_.points, before_.points);
  EXPECT_EQ(after_.tetrahedra, before_.tetrahedra);
}

TEST_F(PointRemoval, GivesTheSameMeshEveryTime)
{
  const MeshData data = grid_mesh::make({ 8, 8, 8, {}, 0.2 });
  remove(data, planWith(0.3, { ZLow, XLow }));
  const MeshData first = after_;
  remove(data, planWith(0.3, { ZLow, XLow }));
  EXPECT_EQ(first.points, after_.points);
  EXPECT_EQ(first.tetrahedra, after_.tetrahedra);
  EXPECT_EQ(first.triangles, after_.triangles);
}

TEST_F(PointRemoval, DoesNotTurnCurvedSurfacesTooFar)
{
  // The side y = 0 bulges strongly: its points may not go where that would flatten it.
  const auto bulge = [](const Vector3& p) {
    return Vector3{ p.x, p.y - 0.4 * (1 - p.y) * 4 * p.x * (1 - p.x), p.z };
  };
  const MeshData data = grid_mesh::make({ 6, 6, 10, bulge, 0.1 });
  TetMesh mesh = invariants::build(data);
  const RemovalResult result = removePoints(mesh, patches_, planWith(0.25, { ZLow }), {}, {});
  invariants::expectValid(mesh);
  const auto areas = invariants::patchAreas(toMeshData(mesh));
  for (const auto& [patch, area] : invariants::patchAreas(data))
  {
    EXPECT_NEAR(areas.at(patch), area, 0.02 * area) << "patch " << patch << ", " << result.text();
  }
}

TEST_F(PointRemoval, StopsOnRequestAndLeavesAValidMesh)
{
  int asked = 0;
  Context context;
  context.cancelled = [&asked]() { return ++asked > 1; };
  const RemovalResult result =
    remove(grid_mesh::make({ 20, 20, 20, {}, 0.2 }), planWith(0.3, { ZLow }), context);
  EXPECT_EQ(result.outcome.kind, Outcome::Kind::Cancelled);
  EXPECT_GT(result.removed, 0u);
  EXPECT_FALSE(result.remaining.empty());
  for (const Index v : result.remaining)
  {
    EXPECT_NE(mesh_.tetAt(v), None);
  }
}

TEST_F(PointRemoval, ReportsProgressUpward)
{
  double last = 0;
  bool upward = true;
  Context context;
  context.progress = [&](double fraction, const char*)
  {
    upward = upward && fraction >= last && fraction <= 1;
    last = fraction;
  };
  remove(grid_mesh::make({ 12, 12, 12, {}, 0.2 }), planWith(0.3, { ZLow }), context);
  EXPECT_TRUE(upward);
  EXPECT_GT(last, 0);
}

TEST_F(PointRemoval, RefusesPatchesWithoutARow)
{
  TetMesh mesh = invariants::build(grid_mesh::make({ 2, 2, 2 }));
  const RemovalResult result = removePoints(mesh, { { "fluid", PatchType::Patch } }, LayerPlan(1), {}, {});
  EXPECT_EQ(result.outcome.kind, Outcome::Kind::BadInput);
  EXPECT_FALSE(result.outcome.message.empty());
}

TEST(RemovalVerdict, EachHasAName)
{
  for (int i = 0; i < static_cast<int>(RemovalVerdict::Count); ++i)
  {
    EXPECT_STRNE(nameOf(static_cast<RemovalVerdict>(i)), "unknown");
  }
}
} // namespace

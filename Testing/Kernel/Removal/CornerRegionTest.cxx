#include "Removal/CornerRegion.h"

#include "Removal/RegionPlan.h"
#include "Support/GridMesh.h"
#include "Support/Invariants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace
{
using namespace ransmesh;
using grid_mesh::XLow;
using grid_mesh::ZLow;
using test::planWith;

constexpr int Count = 10;            // cubes along a side
constexpr double Size = 1.0 / Count; // of a cube
constexpr double NoMargin = 1e-9;

struct Found
{
  TetMesh mesh;
  std::set<Index> points;
};

Found find(const LayerPlan& plan, const std::function<Vector3(const Vector3&)>& map = {},
  const std::set<int>& interfaces = {})
{
  Found found{ invariants::build(grid_mesh::make({ Count, Count, Count, map })), {} };
  PatchTable patches = grid_mesh::patches(PatchType::Symmetry);
  for (const int p : interfaces)
  {
    patches[p].type = PatchType::Interface;
  }
  const auto points = findCornerPoints(found.mesh, BoundaryStars(found.mesh), classify(found.mesh, patches),
    changeablePatches(patches, plan), plan, NoMargin);
  for (const CornerPoint& point : points)
  {
    EXPECT_TRUE(found.points.insert(point.vertex).second) << "each once";
  }
  return found;
}

TEST(CornerRegion, TakesWhatLiesInTheOtherWallsLayers)
{
  const double thickness = 2 * Size;
  const Found found = find(planWith(thickness, { XLow, ZLow }));
  for (Index v = 0; v < static_cast<Index>(found.mesh.vertexCount()); ++v)
  {
    const Vector3& p = found.mesh.point(v);
    const bool inside =
      (p.x == 0 && p.z > 0 && p.z <= thickness) || (p.z == 0 && p.x > 0 && p.x <= thickness);
    EXPECT_EQ(found.points.count(v) > 0, inside) << p.x << " " << p.y << " " << p.z;
  }
}

TEST(CornerRegion, EachWallHasItsOwnThickness)
{
  LayerPlan plan = planWith(Size, { XLow, ZLow });
  plan[ZLow].firstHeight = 3 * Size; // so XLow's points give way as far as that
  const Found found = find(plan);
  for (const Index v : found.points)
  {
    const Vector3& p = found.mesh.point(v);
    EXPECT_LE(p.x, Size + NoMargin);
    EXPECT_LE(p.z, 3 * Size + NoMargin);
  }
  EXPECT_EQ(found.points.size(), (1u + 3u) * (Count + 1u));
}

TEST(CornerRegion, RidgePointsGoFromCornersOfThreeWalls)
{
  const double thickness = 2 * Size;
  const Found found = find(planWith(thickness, { 1, 2, 3, 4, 5, 6 }));
  std::size_t onRidges = 0;
  for (const Index v : found.points)
  {
    const Vector3& p = found.mesh.point(v);
    const auto onSide = [](double x) { return x == 0 || x == 1; };
    const auto nearSide = [&](double x) { return std::min(x, 1 - x) <= thickness + NoMargin; };
    EXPECT_LT(onSide(p.x) + onSide(p.y) + onSide(p.z), 3) << "corners stay";
    onRidges += onSide(p.x) + onSide(p.y) + onSide(p.z) == 2;
    EXPECT_GE(nearSide(p.x) + nearSide(p.y) + nearSide(p.z), 2);
  }
  EXPECT_EQ(onRidges, 12u * 2 * 2) << "two at each end of each ridge";
}

TEST(CornerRegion, SkewCornersReachFartherAlongTheWall)
{
  // XLow leans over ZLow by 30 degrees to 60: the column along the bisector is 1.8 tan(60 degrees) along either wall.
  const auto lean = [](const Vector3& p) { return Vector3{ p.x + p.z / 2, p.y, p.z * std::sqrt(3) / 2 }; };
  const Found upright = find(planWith(1.8 * Size, { XLow, ZLow }));
  const Found leaning = find(planWith(1.8 * Size, { XLow, ZLow }), lean);
  EXPECT_EQ(upright.points.size(), 2u * (Count + 1));
  EXPECT_EQ(leaning.points.size(), 6u * (Count + 1));
}

TEST(CornerRegion, WideCornersMakeRoomForTheirLeaningColumn)
{
  // The walls enclose 120 degrees: the column along the bisector leans by 30, layers 2 thick reach 1.15.
  const auto lean = [](const Vector3& p) { return Vector3{ p.x - p.z / 2, p.y, p.z * std::sqrt(3) / 2 }; };
  EXPECT_EQ(find(planWith(2 * Size, { XLow, ZLow }), lean).points.size(), 2u * (Count + 1));
  EXPECT_TRUE(find(planWith(1.6 * Size, { XLow, ZLow }), lean).points.empty());
}

TEST(CornerRegion, IsEmptyWhereNothingIsInTheWay)
{
  EXPECT_TRUE(find(planWith(0.9 * Size, { XLow, ZLow })).points.empty()) << "thin layers";
  EXPECT_TRUE(find(planWith(2 * Size, { ZLow })).points.empty()) << "one wall";
  const auto flat = [](const Vector3& p) { return Vector3{ p.x - 3 * p.z, p.y, p.z }; };
  EXPECT_TRUE(find(planWith(2 * Size, { XLow, ZLow }), flat).points.empty()) << "a flat corner";
}

TEST(CornerRegion, LeavesInterfacesAlone)
{
  const Found found = find(planWith(2 * Size, { XLow, ZLow }), {}, { grid_mesh::YLow });
  EXPECT_FALSE(found.points.empty());
  for (const Index v : found.points)
  {
    EXPECT_GT(found.mesh.point(v).y, 0);
  }
}

TEST(CornerRegion, LeavesConvexEdgesAlone)
{
  grid_mesh::Grid grid{ Count, Count, Count };
  MeshData data = grid_mesh::make(grid);
  const int step = grid_mesh::carve(data, [](const Vector3& p) { return p.x < 0.5 && p.z < 0.5; });
  const TetMesh mesh = invariants::build(data);
  const PatchTable patches = grid_mesh::patches(PatchType::Symmetry, step);
  LayerPlan plan = planWith(2 * Size, { ZLow });
  plan.resize(step + 1, plan[ZLow]);
  plan[ZLow] = {};
  EXPECT_TRUE(findCornerPoints(
    mesh, BoundaryStars(mesh), classify(mesh, patches), changeablePatches(patches, plan), plan, NoMargin)
                .empty());
  plan[ZLow] = plan[step];
  EXPECT_FALSE(findCornerPoints(
    mesh, BoundaryStars(mesh), classify(mesh, patches), changeablePatches(patches, plan), plan, NoMargin)
                 .empty());
}
} // namespace

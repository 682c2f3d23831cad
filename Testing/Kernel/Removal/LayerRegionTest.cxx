#include "Removal/LayerRegion.h"

#include "Removal/RegionPlan.h"
#include "Removal/WallReach.h"
#include "Support/GridMesh.h"
#include "Support/Invariants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using namespace ransmesh;
using grid_mesh::XLow;
using grid_mesh::YLow;
using grid_mesh::ZHigh;
using grid_mesh::ZLow;
using test::planWith;

struct Case
{
  TetMesh mesh;
  PatchTable patches = grid_mesh::patches(PatchType::Symmetry);

  explicit Case(const grid_mesh::Grid& grid)
    : mesh(invariants::build(grid_mesh::make(grid)))
  {
  }
  LayerRegion region(const LayerPlan& plan, double margin = 0) const
  {
    return findLayerRegion(
      mesh, BoundaryStars(mesh), classify(mesh, patches), changeablePatches(patches, plan), plan, margin);
  }
};

TEST(LayerRegion, HoldsWhatLiesWithinTheThickness)
{
  const Case box({ 8, 8, 8, {}, 0.2 });
  const double thickness = 0.4;
  const LayerRegion region = box.region(planWith(thickness, { ZLow }));
  const Classification c = classify(box.mesh, box.patches);
  for (Index v = 0; v < static_cast<Index>(box.mesh.vertexCount()); ++v)
  {
    const double height = box.mesh.point(v).z;
    const bool expected = height > 0 && height <= thickness;
    EXPECT_EQ(region.isMarked[v] != 0, expected) << "height " << height;
    EXPECT_EQ(std::count(region.marked.begin(), region.marked.end(), v), expected ? 1 : 0);
    if (expected)
    {
      EXPECT_NE(c.kind[v], VertexKind::Corner);
      EXPECT_FLOAT_EQ(region.reach[v], static_cast<float>(thickness));
      EXPECT_GT(region.attainable[v], 0);
    }
  }
}

TEST(LayerRegion, TakesTheNearestOfSeveralWalls)
{
  const Case box({ 8, 8, 8 });
  LayerPlan plan = planWith(0.2, { XLow, ZLow });
  plan[ZLow].firstHeight = 0.4;
  const LayerRegion region = box.region(plan);
  for (Index v = 0; v < static_cast<Index>(box.mesh.vertexCount()); ++v)
  {
    const Vector3& p = box.mesh.point(v);
    const bool onWall = p.x == 0 || p.z == 0;
    EXPECT_EQ(region.isMarked[v] != 0, !onWall && (p.x <= 0.2 || p.z <= 0.4));
  }
}

TEST(LayerRegion, LeavesInterfacesAndOtherWallsAlone)
{
  Case box({ 6, 6, 6 });
  box.patches[XLow].type = PatchType::Interface;
  const LayerRegion region = box.region(planWith(1.5, { ZLow, YLow }));
  for (Index v = 0; v < static_cast<Index>(box.mesh.vertexCount()); ++v)
  {
    const Vector3& p = box.mesh.point(v);
    if (p.x == 0 || p.y == 0 || p.z == 0)
    {
      EXPECT_FALSE(region.isMarked[v]);
    }
  }
}

TEST(LayerRegion, IsEmptyForThinLayers)
{
  const Case box({ 8, 8, 8, {}, 0.1 });
  EXPECT_TRUE(box.region(planWith(1e-4, { ZLow, ZHigh }), 0.4).marked.empty());
}

TEST(LayerRegion, MarginIsInTermsOfTheWallsTriangles)
{
  const Case box({ 8, 8, 8 });
  EXPECT_TRUE(box.region(planWith(1e-4, { ZLow }), 0.5).marked.empty());
  EXPECT_FALSE(box.region(planWith(1e-4, { ZLow }), 1.2).marked.empty());
}

TEST(LayerRegion, ThicknessIsLimitedByTheLocalSize)
{
  LayerSpecification s;
  s.firstHeight = 1;
  s.growthRate = 2;
  s.numberOfLayers = 5;
  const LayerHeights heights(s); // spacings 1, 2, 4, 8, 16
  EXPECT_DOUBLE_EQ(limitedThickness(heights, 0.5, 0.1), 0);
  EXPECT_DOUBLE_EQ(limitedThickness(heights, 0.5, 2), 1);
  EXPECT_DOUBLE_EQ(limitedThickness(heights, 0.5, 9), 7);
  EXPECT_DOUBLE_EQ(limitedThickness(heights, 0.5, 1000), 31);
}

TEST(LayerRegion, IsEmptyWhereNotOneLayerFits)
{
  const Case box({ 8, 8, 8 });
  LayerPlan plan = planWith(0.4, { ZLow });
  plan[ZLow].isotropicFraction = 0.1;
  EXPECT_TRUE(box.region(plan, 1.2).marked.empty());
}

TEST(LayerRegion, PointsBeyondACeilingAreBeyondReach)
{
  const auto bumps = [](const Vector3& p) {
    return Vector3{ p.x, p.y, p.z + 0.15 * (1 - p.z) * std::sin(7 * p.x) * std::cos(5 * p.y) };
  };
  const Case box({ 8, 8, 8, bumps, 0.2 });
  const BoundaryStars stars(box.mesh);
  const WallReach walls(box.mesh, stars, planWith(0.3, { ZLow }), 0.1);
  const auto count = static_cast<Index>(box.mesh.vertexCount());
  std::size_t below = 0;
  for (Index w = 0; w < count; ++w)
  {
    for (Index v = 0; walls.isWall(w) && v < count; ++v)
    {
      const auto around = walls.at(w);
      const bool reached = std::any_of(
        around.begin(), around.end(), [&](Index t) { return walls.reaches(box.mesh.point(v), t); });
      const bool isBeyond = walls.ceilingOver(w).isBelow(box.mesh.point(v));
      EXPECT_FALSE(reached && isBeyond);
      below += !isBeyond;
    }
  }
  EXPECT_GT(below, 0U);
}
} // namespace

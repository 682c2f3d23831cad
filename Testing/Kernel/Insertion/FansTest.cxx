#include "Insertion/EnrichmentChecks.h"

#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace ransmesh;
using namespace grid_mesh;
using namespace enrichment_checks;

namespace
{
void expectAllInserted(const EnrichedMesh& enriched)
{
  EXPECT_EQ(enriched.report.fans.opened, enriched.report.fans.planned);
  EXPECT_EQ(enriched.report.pointsInserted, enriched.report.pointsRequested);
  EXPECT_EQ(enriched.report.columnsByReason[static_cast<int>(StopReason::Complete)], enriched.report.columns);
}

// Of a fan's columns the lowest speaks for the point of the wall.
void expectLowestOfEachFan(const EnrichedMesh& enriched)
{
  std::map<Index, int> pointsOf; // by column
  std::map<Index, Index> rootOf;
  for (std::size_t i = 0; i < enriched.column.size(); ++i)
  {
    if (enriched.column[i] != None)
    {
      ++pointsOf[enriched.column[i]];
      rootOf[enriched.column[i]] = enriched.origin[i];
    }
  }
  std::map<Index, int> lowest; // by root
  for (const auto& [column, points] : pointsOf)
  {
    const bool isMain = column < static_cast<Index>(enriched.wallPoints.size()); // which has its base, too
    int& least = lowest.try_emplace(rootOf[column], points).first->second;
    least = std::min(least, isMain ? points - 1 : points);
  }
  for (const WallPoint& point : enriched.wallPoints)
  {
    EXPECT_EQ(point.layersAchieved, lowest.at(enriched.origin[point.point]));
  }
}

bool within(double x, double low, double high)
{
  return x > low && x < high;
}

// A body in the middle of a box of symmetry planes; everything of the body is a wall.
struct Carved
{
  MeshData mesh;
  PatchTable table;
  int wall;

  Carved(const Grid& grid, const std::function<bool(const Vector3&)>& body)
    : mesh(make(grid))
    , table(patches(PatchType::Symmetry, 7))
    , wall(carve(mesh, body))
  {
    table[wall].type = PatchType::Wall;
  }
  EnrichedMesh enriched(double firstHeight, int layers) const
  {
    return enrichAndCheck(mesh, table, planFor(8, { wall }, firstHeight, layers));
  }
};

bool inCube(const Vector3& x)
{
  return within(x.x, 0.25, 0.75) && within(x.y, 0.25, 0.75) && within(x.z, 0.25, 0.75);
}
} // namespace

TEST(Fans, ACubeHasFansAtEdgesAndCorners)
{
  const Carved cube({ 8, 8, 8 }, inCube);
  const EnrichedMesh enriched = cube.enriched(1e-4, 10);
  expectAllInserted(enriched);
  // Of a right angle two columns beside those of the faces: 3 more at each of the 36 ridge points, of
  // which one is the main one; at the 8 corners 9 around the main one.
  EXPECT_EQ(enriched.report.fans.opened, 36u * 3u + 8u * 9u);
  EXPECT_LT(largestLayerAngle(enriched), 165);
}

TEST(Fans, ACubeTurnedToNoAxisHasTheSame)
{
  const Carved cube({ 8, 8, 8, turned },
    [](const Vector3& x)
    {
      // The middles are turned too: the body is given by its corners in the middle of the turned box.
      static const Vector3 origin = turned({ 0, 0, 0 });
      static const Vector3 ex = turned({ 1, 0, 0 }) - origin;
      static const Vector3 ey = turned({ 0, 1, 0 }) - origin;
      static const Vector3 ez = turned({ 0, 0, 1 }) - origin;
      const Vector3 d = x - origin;
      return inCube({ dot(d, ex), dot(d, ey), dot(d, ez) });
    });
  const EnrichedMesh enriched = cube.enriched(1e-5, 10);
  expectAllInserted(enriched);
  EXPECT_EQ(enriched.report.fans.opened, 36u * 3u + 8u * 9u);
}

TEST(Fans, ARidgeThatEndsInASymmetryPlaneHasItsFanThere)
{
  const Carved bar({ 6, 6, 6 }, [](const Vector3& x) { return x.x < 0.5 && x.z < 0.5; });
  const EnrichedMesh enriched = bar.enriched(1e-4, 10);
  expectAllInserted(enriched);
  EXPECT_EQ(enriched.report.fans.opened, 7u * 3u);
  // Its points keep exactly to the planes.
  for (std::size_t i = 0; i < enriched.mesh.triangles.size(); ++i)
  {
    if (enriched.mesh.trianglePatch[i] == YLow)
    {
      for (const Index v : enriched.mesh.triangles[i])
      {
        EXPECT_EQ(enriched.mesh.points[v].y, 0);
      }
    }
  }
}

TEST(Fans, ConvexAndConcaveRidgesMeet)
{
  // A block on the floor, floor and block viscous.
  Carved block({ 8, 8, 8 },
    [](const Vector3& x) { return within(x.x, 0.25, 0.75) && within(x.y, 0.25, 0.75) && x.z < 0.5; });
  block.table[ZLow].type = PatchType::Wall;
  const EnrichedMesh enriched =
    enrichAndCheck(block.mesh, block.table, planFor(8, { block.wall, ZLow }, 1e-4, 10));
  expectAllInserted(enriched);
  EXPECT_LT(largestLayerAngle(enriched), 170);
}

TEST(Fans, WiderAnglesMakeFewerColumns)
{
  const Carved bar({ 6, 6, 6 }, [](const Vector3& x) { return x.x < 0.5 && x.z < 0.5; });
  LayerPlan plan = planFor(8, { bar.wall }, 1e-4, 10);
  plan[bar.wall].fanAngle = 45;
  EXPECT_EQ(enrichAndCheck(bar.mesh, bar.table, plan).report.fans.opened, 7u * 2u);
  plan[bar.wall].normalAngle = 100;
  EXPECT_EQ(enrichAndCheck(bar.mesh, bar.table, plan).report.fans.planned, 0u);
}

TEST(Fans, StandBesideEachOtherWithLayersOfAnyThickness)
{
  const Carved cube({ 8, 8, 8 }, inCube);
  for (const double firstHeight : { 1e-7, 1e-3, 5e-3 })
  {
    const EnrichedMesh enriched = cube.enriched(firstHeight, 12);
    EXPECT_GT(enriched.report.pointsInserted, enriched.report.columns);
    expectLowestOfEachFan(enriched);
  }
}

// At the end of a slot the columns at the two ends of the short convex edge lean towards each other: each must be
// joined to the one that turns as far around the edge, not to the one that points most like it.
TEST(Fans, ColumnsAtTheEndsOfAShortEdgeAreMatchedAcrossIt)
{
  constexpr double low = 4.0 / 9;
  constexpr double width = 0.01;
  const auto narrowed = [](const Vector3& p) {
    return Vector3{ p.x, p.y, p.z - (1 - 9 * width) * std::clamp(p.z - low, 0.0, 1.0 / 9) };
  };
  const Carved slotted({ 8, 8, 9, narrowed },
    [](const Vector3& x)
    {
      const bool inSlot = x.x > 0.5 && within(x.z, low, low + width);
      return within(x.x, 0.25, 0.75) && within(x.y, 0.25, 0.75) && within(x.z, 0.2, 0.7) && !inSlot;
    });
  const EnrichedMesh enriched = slotted.enriched(1e-4, 10);
  expectAllInserted(enriched);
  EXPECT_LT(largestLayerAngle(enriched), 165);
}

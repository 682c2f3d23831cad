// Layers written at once are those that points inserted one after the other make.
#include "Insertion/PointByPoint.h"

#include "Insertion/EnrichmentChecks.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace enrichment_checks;
using namespace grid_mesh;

namespace
{
std::vector<std::array<Index, 3>> boundaryOf(const MeshData& mesh)
{
  std::vector<std::array<Index, 3>> faces = mesh.triangles;
  for (auto& face : faces)
  {
    std::sort(face.begin(), face.end());
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

void expectTheSame(const EnrichedMesh& enriched, int wall)
{
  std::vector<std::array<Index, 3>> left;
  const LayerTets made = insertPointByPoint(enriched, left);
  EXPECT_GT(made.size(), 0u);
  EXPECT_TRUE(made == writtenLayers(enriched)) << made.size() << " and " << enriched.report.layerTets;
  // The wall comes back.
  const auto boundary = boundaryOf(enriched.mesh);
  std::size_t ofWall = 0;
  for (std::size_t i = 0; i < enriched.mesh.triangles.size(); ++i)
  {
    std::array<Index, 3> face = enriched.mesh.triangles[i];
    std::sort(face.begin(), face.end());
    if (enriched.mesh.trianglePatch[i] == wall)
    {
      ++ofWall;
      EXPECT_TRUE(std::binary_search(left.begin(), left.end(), face)) << "triangle " << i;
    }
  }
  EXPECT_GT(ofWall, 0u);
  EXPECT_TRUE(std::includes(boundary.begin(), boundary.end(), left.begin(), left.end()));
}
} // namespace

TEST(PointByPoint, GivesTheSameLayersOverAPlate)
{
  const MeshData mesh = make({ 6, 5, 4, turned, 0.2 });
  for (const double firstHeight : { 1e-7, 1e-4, 2e-3 })
  {
    expectTheSame(
      enrichAndCheck(mesh, patches(PatchType::Symmetry), planFor(7, { ZLow }, firstHeight, 20)), ZLow);
  }
}

TEST(PointByPoint, GivesTheSameLayersWhereColumnsEndAtManyLevels)
{
  // A gap that closes; the wall ends before its narrow end.
  const auto wedge = [](const Vector3& p) { return Vector3{ p.x, p.y, p.z * (0.05 + 0.4 * p.x * p.x) }; };
  const auto split = [](Side side, const Vector3& middle)
  { return side == ZLow && middle.x < 0.3 ? 7 : static_cast<int>(side); };
  const MeshData mesh = make({ 12, 5, 6, wedge, 0.1 }, split);
  const EnrichedMesh enriched =
    enrichAndCheck(mesh, patches(PatchType::Symmetry, 7), planFor(8, { ZLow }, 1e-3, 20));
  std::set<int> levels;
  for (const WallPoint& point : enriched.wallPoints)
  {
    levels.insert(point.layersAchieved);
  }
  EXPECT_GT(levels.size(), 4u);
  expectTheSame(enriched, ZLow);
}

TEST(PointByPoint, GivesTheSameFans)
{
  MeshData mesh = make({ 8, 8, 8, {}, 0.1 });
  PatchTable table = patches(PatchType::Symmetry, 7);
  const auto within = [](double x) { return x > 0.25 && x < 0.75; };
  const int wall = carve(mesh, [&](const Vector3& x) { return within(x.x) && within(x.y) && within(x.z); });
  for (const double firstHeight : { 1e-5, 3e-3 })
  {
    const EnrichedMesh enriched = enrichAndCheck(mesh, table, planFor(8, { wall }, firstHeight, 15));
    EXPECT_GT(enriched.report.fans.opened, 0u);
    expectTheSame(enriched, wall);
  }
}

namespace
{
// The level whose height is x; None where there is none.
int levelAt(const LayerHeights& heights, double x)
{
  for (int level = 0; level <= heights.count(); ++level)
  {
    if (std::fabs(x - heights.height(level)) < 1e-12)
    {
      return level;
    }
  }
  return None;
}
} // namespace

// Grids have their own rule: a point at each pair (or triple) of levels, and tetrahedra only within the cells between
// them. Together with the volume, that every mesh here is checked for, that is all there is to say.
TEST(PointByPoint, GridsHaveTheCellsOfTheirLevels)
{
  constexpr int layers = 7;
  const LayerPlan plan = planFor(7, { XLow, YLow, ZLow }, 1e-3, layers);
  const EnrichedMesh enriched = enrichAndCheck(make({ 4, 4, 4 }), patches(PatchType::Symmetry), plan);
  const LayerHeights heights(plan[ZLow]);
  std::map<std::array<int, 3>, int> tets; // by the cell's upper corner
  for (const auto& tet : enriched.mesh.tetrahedra)
  {
    std::array<int, 3> low{ layers, layers, layers };
    std::array<int, 3> high{ 0, 0, 0 };
    bool isInside = true;
    for (const Index v : tet)
    {
      for (int i = 0; i < 3; ++i)
      {
        const int level = levelAt(heights, enriched.mesh.points[v][i]);
        isInside = isInside && level != None;
        low[i] = std::min(low[i], level);
        high[i] = std::max(high[i], level);
      }
    }
    if (isInside)
    {
      ++tets[high];
      for (int i = 0; i < 3; ++i)
      {
        EXPECT_EQ(high[i] - low[i], 1);
      }
    }
  }
  // Each cell is cut into five or six.
  EXPECT_EQ(tets.size(), static_cast<std::size_t>(layers * layers * layers));
  for (const auto& [cell, count] : tets)
  {
    EXPECT_TRUE(count == 5 || count == 6) << cell[0] << ' ' << cell[1] << ' ' << cell[2] << ": " << count;
  }
}

#include "Domain/SurfaceSizes.h"
#include "Triangles/FeatureSplit.h"
#include "Triangles/SurfaceEdges.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
using namespace ransmesh;

SurfaceMesh tetrahedron()
{
  return { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } }, { 1, 1, 2, 1 } };
}

double longestEdge(const SurfaceMesh& surface)
{
  double longest = 0;
  for (const SurfaceEdge& e : sortedEdges(surface))
  {
    longest = std::max(longest, distance(surface.points[e.a], surface.points[e.b]));
  }
  return longest;
}

double areaOf(const SurfaceMesh& surface, int patch)
{
  double area = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto& v = surface.triangles[t];
    const auto& p = surface.points;
    area += surface.patch[t] == patch ? 0.5 * norm(cross(p[v[1]] - p[v[0]], p[v[2]] - p[v[0]])) : 0;
  }
  return area;
}
} // namespace

TEST(SurfaceSizes, HalvesLongEdgesAndStaysClosed)
{
  SurfaceMesh surface = tetrahedron();
  const double area = areaOf(surface, 2);
  EXPECT_TRUE(halveLongEdges(surface, [](const Vector3&) { return 0.1; }));
  EXPECT_NEAR(enclosedVolume(surface), 1.0 / 6, 1e-12);
  EXPECT_LE(longestEdge(surface), 0.15);
  EXPECT_NEAR(areaOf(surface, 2), area, 1e-12);
  forEachEdge(sortedEdges(surface),
    [](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      ASSERT_EQ(last - first, 2);
      EXPECT_NE(first[0].forward, first[1].forward);
    });
}

TEST(SurfaceSizes, LeavesShortEdgesAlone)
{
  SurfaceMesh surface = tetrahedron();
  EXPECT_TRUE(
    halveLongEdges(surface, [](const Vector3&) { return std::numeric_limits<double>::infinity(); }));
  EXPECT_EQ(surface.triangles.size(), 4u);
}

TEST(SurfaceSizes, GivesUpBeforeMemoryEnds)
{
  SurfaceMesh surface = tetrahedron();
  EXPECT_FALSE(halveLongEdges(
    surface, [](const Vector3&) { return 1e-9; }, 10000));
  EXPECT_LT(surface.triangles.size(), 50000u);
}

TEST(SurfaceSizes, LimitsGrowthAlongTheSurface)
{
  SurfaceMesh surface = tetrahedron();
  // Refined around one corner only.
  halveLongEdges(surface, [](const Vector3& x) { return 0.02 + norm(x); });
  const double slope = 0.2;
  const std::vector<double> size = sizesOnSurface(surface, slope);
  for (const SurfaceEdge& e : sortedEdges(surface))
  {
    EXPECT_LE(
      std::fabs(size[e.a] - size[e.b]), slope * distance(surface.points[e.a], surface.points[e.b]) + 1e-12);
  }
}

TEST(FeatureSplit, PartsAreNamedAndNumbered)
{
  SurfaceMesh surface = tetrahedron();
  surface.patch.assign(4, 1);
  PatchTable patches = { { "fluid", PatchType::Patch }, { "body", PatchType::Wall } };
  splitByAngle(surface, patches, 1, 30);
  ASSERT_EQ(patches.size(), 5u);
  EXPECT_EQ(patches[1].name, "body_1");
  EXPECT_EQ(patches[4].name, "body_4");
  EXPECT_EQ(patches[4].type, PatchType::Wall);
  splitByAngle(surface, patches, 1, 179.9);
  EXPECT_EQ(patches.size(), 5u);
}

#include "Triangles/SurfaceCheck.h"
#include "Surface/Preparation.h"
#include "Triangles/SurfaceIntersections.h"
#include "Triangles/SurfaceRepair.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using namespace ransmesh;

PatchTable OnePatch = { { "fluid", PatchType::Patch }, { "body", PatchType::Patch } };

SurfaceMesh surfaceOf(std::vector<Vector3> points, std::vector<std::array<Index, 3>> triangles)
{
  SurfaceMesh surface{ std::move(points), std::move(triangles), {} };
  surface.patch.assign(surface.triangles.size(), 1);
  return surface;
}

SurfaceMesh tetrahedron(double shift = 0)
{
  return surfaceOf({ { shift, 0, 0 }, { shift + 1, 0, 0 }, { shift, 1, 0 }, { shift, 0, 1 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } });
}

std::ptrdiff_t turnedCount(const SurfaceMesh& surface)
{
  const std::vector<char> isTurned = turnedTriangles(surface);
  return std::count(isTurned.begin(), isTurned.end(), 1);
}

void add(SurfaceMesh& surface, const SurfaceMesh& other)
{
  const auto offset = static_cast<Index>(surface.points.size());
  surface.points.insert(surface.points.end(), other.points.begin(), other.points.end());
  for (const auto& t : other.triangles)
  {
    surface.triangles.push_back({ t[0] + offset, t[1] + offset, t[2] + offset });
    surface.patch.push_back(1);
  }
}
} // namespace

TEST(SurfaceCheck, AcceptsASoundSurface)
{
  SurfaceMesh surface = tetrahedron();
  const SurfaceVerdict verdict = prepareSurface(surface, OnePatch, {}, {});
  EXPECT_TRUE(verdict.outcome.ok()) << verdict.outcome.message;
  EXPECT_TRUE(verdict.findings.empty());
  EXPECT_TRUE(verdict.repairs.empty());
}

TEST(SurfaceCheck, MergesEqualPoints)
{
  SurfaceMesh surface =
    surfaceOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { -0.0, 0, 0 }, { 5, 5, 5 } },
      { { 0, 2, 1 }, { 4, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } });
  EXPECT_TRUE(prepareSurface(surface, OnePatch, {}, {}).outcome.ok());
  EXPECT_EQ(surface.points.size(), 4u);
}

TEST(SurfaceCheck, TellsCollinearFromThin)
{
  const SurfaceMesh surface =
    surfaceOf({ { 0, 0, 0 }, { 1, 1, 1 }, { 3, 3, 3 }, { 3, 3, std::nextafter(3.0, 4) } },
      { { 0, 1, 2 }, { 0, 1, 3 } });
  EXPECT_TRUE(isDegenerate(surface, 0));
  EXPECT_FALSE(isDegenerate(surface, 1));
}

TEST(SurfaceCheck, KnowsTinyTrianglesFarAway)
{
  const double far = 1e6;
  const double step = 1e-9;
  const SurfaceMesh surface =
    surfaceOf({ { far, 0, 0 }, { far, step, 0 }, { far, 0, step } }, { { 0, 1, 2 } });
  EXPECT_FALSE(isDegenerate(surface, 0));
}

TEST(SurfaceCheck, FindsPiercedTriangles)
{
  SurfaceMesh surface = tetrahedron();
  add(surface, tetrahedron(0.25));
  const SurfaceVerdict verdict = prepareSurface(surface, OnePatch, {}, {});
  EXPECT_EQ(verdict.outcome.kind, Outcome::Kind::BadInput);
  EXPECT_FALSE(verdict.findings.empty());
}

TEST(SurfaceIntersections, LetsNeighboursTouch)
{
  EXPECT_TRUE(findIntersections(tetrahedron()).empty());
}

TEST(SurfaceIntersections, FindsFoldsAtACommonEdge)
{
  const SurfaceMesh fold =
    surfaceOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } }, { { 0, 1, 2 }, { 1, 0, 3 } });
  EXPECT_EQ(findIntersections(fold).size(), 1u);
  const SurfaceMesh flat =
    surfaceOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, -1, 0 } }, { { 0, 1, 2 }, { 1, 0, 3 } });
  EXPECT_TRUE(findIntersections(flat).empty());
}

TEST(SurfaceIntersections, FindsCutsThroughACommonPoint)
{
  const SurfaceMesh cut = surfaceOf(
    { { 0, 0, 0 }, { 2, -1, 0 }, { 2, 1, 0 }, { 2, 0, 1 }, { 2, 0, -1 } }, { { 0, 1, 2 }, { 0, 3, 4 } });
  EXPECT_EQ(findIntersections(cut).size(), 1u);
}

TEST(SurfaceRepair, CountsTheSmallerPartAsTurned)
{
  SurfaceMesh surface = tetrahedron();
  EXPECT_EQ(turnedCount(surface), 0);
  for (int i = 0; i < 3; ++i)
  {
    std::swap(surface.triangles[i][0], surface.triangles[i][1]);
  }
  EXPECT_EQ(turnedCount(surface), 1);
}

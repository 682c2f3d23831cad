#include "Remeshing/SurfaceRemeshing.h"

#include "Triangles/SurfaceEdges.h"

#include <gtest/gtest.h>

#include <set>

namespace
{
using namespace ransmesh;

// A tetrahedron whose faces are needles: one edge is a hundred times shorter than the others.
SurfaceMesh needles()
{
  return { { { 0, 0, 0 }, { 0.01, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } }, { 1, 2, 3, 4 } };
}

Outcome remesh(SurfaceMesh& surface, double length)
{
  RemeshingOptions options;
  options.length = length;
  RemeshingReport report;
  return remeshSurface(surface, options, report);
}
} // namespace

TEST(SurfaceRemeshing, MakesTrianglesOfOneSizeAndKeepsPatchesAndCorners)
{
  SurfaceMesh surface = needles();
  ASSERT_TRUE(remesh(surface, 0.02).ok());
  EXPECT_EQ(std::set<int>(surface.patch.begin(), surface.patch.end()), (std::set<int>{ 1, 2, 3, 4 }));
  forEachEdge(sortedEdges(surface),
    [&](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      EXPECT_EQ(last - first, 2);
      EXPECT_LT(distance(surface.points[first->a], surface.points[first->b]), 0.04);
    });
  const Extent extent = extentOf(surface.points);
  EXPECT_EQ(extent.high, (Vector3{ 0.01, 1, 1 }));
  EXPECT_EQ(extent.low, (Vector3{ 0, 0, 0 }));
}

TEST(SurfaceRemeshing, GivesTheSameSurfaceTwice)
{
  SurfaceMesh first = needles();
  SurfaceMesh second = needles();
  ASSERT_TRUE(remesh(first, 0.03).ok());
  ASSERT_TRUE(remesh(second, 0.03).ok());
  EXPECT_EQ(first.points, second.points);
  EXPECT_EQ(first.triangles, second.triangles);
}

// A box whose middle wall divides it in two: three triangles meet at the wall's edges.
SurfaceMesh dividedBox()
{
  SurfaceMesh box;
  for (const double x : { 0.0, 1.0, 2.0 })
  {
    for (const auto& [y, z] :
      { std::pair(0.0, 0.0), std::pair(1.0, 0.0), std::pair(1.0, 1.0), std::pair(0.0, 1.0) })
    {
      box.points.push_back({ x, y, z });
    }
  }
  const auto quad = [&](Index a, Index b, Index c, Index d, int patch)
  {
    box.triangles.push_back({ a, b, c });
    box.triangles.push_back({ a, c, d });
    box.patch.insert(box.patch.end(), 2, patch);
  };
  quad(0, 3, 2, 1, 1);
  quad(4, 5, 6, 7, 2);
  quad(8, 9, 10, 11, 1);
  for (Index part = 0; part < 8; part += 4)
  {
    for (Index i = 0; i < 4; ++i)
    {
      quad(part + i, part + (i + 1) % 4, part + 4 + (i + 1) % 4, part + 4 + i, 1);
    }
  }
  return box;
}

TEST(SurfaceRemeshing, KeepsEdgesWhereMoreThanTwoTrianglesMeet)
{
  SurfaceMesh surface = dividedBox();
  ASSERT_TRUE(remesh(surface, 0.2).ok());
  double length = 0; // of the edges where three triangles meet
  forEachEdge(sortedEdges(surface),
    [&](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      ASSERT_TRUE(last - first == 2 || last - first == 3);
      length += last - first == 3 ? distance(surface.points[first->a], surface.points[first->b]) : 0;
    });
  EXPECT_NEAR(length, 4, 1e-12);
  EXPECT_GT(surface.triangles.size(), 300u);
}

// A plate of 1 x 1 x 0.02, two triangles a side.
SurfaceMesh plate()
{
  SurfaceMesh plate;
  for (int i = 0; i < 8; ++i)
  {
    plate.points.push_back({ i & 1 ? 1.0 : 0.0, i & 2 ? 1.0 : 0.0, i & 4 ? 0.02 : 0.0 });
  }
  const int sides[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 },
    { 1, 3, 7, 5 } };
  for (const auto& s : sides)
  {
    plate.triangles.push_back({ s[0], s[1], s[2] });
    plate.triangles.push_back({ s[0], s[2], s[3] });
  }
  plate.patch.assign(12, 1);
  return plate;
}

TEST(SurfaceRemeshing, FollowsTheWidthOfStrips)
{
  SurfaceMesh surface = plate();
  RemeshingOptions options;
  options.length = 0.1;
  RemeshingReport report;
  ASSERT_TRUE(remeshSurface(surface, options, report).ok());
  EXPECT_GT(report.lowAngle, 20);
  SurfaceMesh coarse = plate(); // strips too narrow to be followed
  options.length = 1;
  options.smallest = 1;
  ASSERT_TRUE(remeshSurface(coarse, options, report).ok());
  EXPECT_LT(coarse.triangles.size(), 100u);
}

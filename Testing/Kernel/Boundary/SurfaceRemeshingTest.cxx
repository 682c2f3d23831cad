#include "Boundary/SurfaceRemeshing.h"

#include "Boundary/SurfaceEdges.h"

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
} // namespace

TEST(SurfaceRemeshing, MakesTrianglesOfOneSizeAndKeepsPatchesAndCorners)
{
  SurfaceMesh surface = needles();
  ASSERT_TRUE(remeshSurface(surface, 0.02, 30).ok());
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
  ASSERT_TRUE(remeshSurface(first, 0.03, 30).ok());
  ASSERT_TRUE(remeshSurface(second, 0.03, 30).ok());
  EXPECT_EQ(first.points, second.points);
  EXPECT_EQ(first.triangles, second.triangles);
}

TEST(SurfaceRemeshing, RefusesBranchingSurfaces)
{
  SurfaceMesh surface = needles();
  surface.points.push_back({ 0, 0, -1 });
  surface.triangles.push_back({ 0, 1, 4 });
  surface.patch.push_back(1);
  EXPECT_FALSE(remeshSurface(surface, 0.03, 30).ok());
  EXPECT_EQ(surface.triangles.size(), 5u);
}

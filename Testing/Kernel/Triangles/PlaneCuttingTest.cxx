#include "Triangles/PlaneCutting.h"

#include "Triangles/SurfaceEdges.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using namespace ransmesh;

// The unit cube, two triangles a side.
SurfaceMesh cube()
{
  SurfaceMesh surface;
  for (int i = 0; i < 8; ++i)
  {
    surface.points.push_back({ double(i & 1), double(i >> 1 & 1), double(i >> 2) });
  }
  surface.triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 },
    { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } };
  surface.patch.assign(12, 1);
  return surface;
}

// Open edges, all of which must lie in the plane.
std::size_t openEdges(const SurfaceMesh& surface, const AxisPlane& plane)
{
  std::size_t open = 0;
  forEachEdge(sortedEdges(surface),
    [&](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      if (last - first == 1)
      {
        ++open;
        EXPECT_TRUE(plane.holds(surface.points[first->a]) && plane.holds(surface.points[first->b]));
      }
    });
  return open;
}

TEST(PlaneCutting, KeepsTheSideThatIsWanted)
{
  for (const bool above : { true, false })
  {
    SurfaceMesh surface = cube();
    const AxisPlane plane = { 2, 0.5, above };
    EXPECT_GT(cutByPlane(surface, plane, 1e-9, 30), 0u);
    EXPECT_GE(openEdges(surface, plane), 4u);
    for (const auto& t : surface.triangles)
    {
      for (const Index v : t)
      {
        EXPECT_TRUE(above ? surface.points[v].z >= 0.5 : surface.points[v].z <= 0.5);
      }
    }
  }
}

TEST(PlaneCutting, KeepsRidgesAndCorners)
{
  SurfaceMesh surface = cube();
  cutByPlane(surface, { 2, 0.05, true }, 1e-9, 30); // near to the lower corners
  for (const auto& t : surface.triangles)
  {
    for (const Index v : t)
    {
      const Vector3& p = surface.points[v];
      const auto onSide = [](double x) { return x == 0 || x == 1; };
      EXPECT_TRUE(onSide(p.x) || onSide(p.y) || p.z == 1) << p.x << " " << p.y << " " << p.z;
      EXPECT_GE(p.z, 0.05);
    }
  }
}

TEST(PlaneCutting, TakesAwayTrianglesInThePlane)
{
  SurfaceMesh surface = cube();
  const AxisPlane plane = { 2, 0, true };
  EXPECT_EQ(cutByPlane(surface, plane, 1e-9), 2u);
  EXPECT_EQ(surface.triangles.size(), 10u);
  EXPECT_EQ(openEdges(surface, plane), 4u);
}

TEST(PlaneCutting, PutsNearbyPointsOnThePlane)
{
  SurfaceMesh surface = cube();
  surface.points[0].z = 1e-8;
  surface.points[3].z = -1e-8;
  const AxisPlane plane = { 2, 0, true };
  cutByPlane(surface, plane, 1e-6);
  EXPECT_EQ(surface.triangles.size(), 10u);
  EXPECT_EQ(openEdges(surface, plane), 4u);
}
} // namespace

#include "Remeshing/FlatTriangles.h"

#include "Domain/SurfaceSizes.h"
#include "Triangles/SurfaceEdges.h"
#include "Triangles/SurfaceIntersections.h"
#include "Triangles/SurfaceTriangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace
{
using namespace ransmesh;

// A box of 1 x width x 0.1 whose long edge at y = z = 0 has two parts more on the opposite edge of the bottom:
// the triangle on the whole edge is a cap of which no swap rids it, if the box is thin.
SurfaceMesh bar(double width)
{
  return { { { 0, 0, 0 }, { 1, 0, 0 }, { 1, width, 0 }, { 0.4, width, 0 }, { 0, width, 0 }, { 0, 0, 0.1 },
             { 1, 0, 0.1 }, { 1, width, 0.1 }, { 0, width, 0.1 } },
    { { 0, 3, 1 }, { 1, 3, 2 }, { 0, 4, 3 }, // bottom
      { 5, 6, 7 }, { 5, 7, 8 },              // top
      { 0, 1, 6 }, { 0, 6, 5 },              // front
      { 2, 3, 7 }, { 3, 8, 7 }, { 3, 4, 8 }, // back
      { 1, 2, 7 }, { 1, 7, 6 }, { 4, 0, 5 }, { 4, 5, 8 } },
    { 1, 1, 1, 2, 2, 3, 3, 4, 4, 4, 5, 5, 6, 6 } };
}

void expectClosed(const SurfaceMesh& surface)
{
  forEachEdge(sortedEdges(surface),
    [](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      ASSERT_EQ(last - first, 2);
      EXPECT_NE(first[0].forward, first[1].forward);
    });
}

double areaOfPatch(const SurfaceMesh& surface, int patch)
{
  double twice = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    twice += surface.patch[t] == patch ? norm(areaVector(surface, surface.triangles[t])) : 0;
  }
  return 0.5 * twice;
}
} // namespace

TEST(FlatTriangles, AreNotSplitWhereThatIsNotWanted)
{
  SurfaceMesh surface = bar(0.01);
  const std::size_t points = surface.points.size();
  const FlatTriangleReport report = mendFlatTriangles(surface, 10, {}, false);
  EXPECT_EQ(report.splits, 0u);
  EXPECT_EQ(report.flatAfter, 1u);
  EXPECT_EQ(surface.points.size(), points);
}

TEST(FlatTriangles, AreSplitAtTheFootWhereNoSwapHelps)
{
  SurfaceMesh surface = bar(0.01);
  const SurfaceMesh before = surface;
  ASSERT_EQ(swapDiagonals(surface, 10).flatAfter, 1u);
  const FlatTriangleReport report = mendFlatTriangles(surface, 10);
  EXPECT_EQ(report.flatBefore, 1u);
  EXPECT_EQ(report.flatAfter, 0u);
  EXPECT_LE(report.largestAfter, FlatTriangleAngle);
  EXPECT_GE(report.splits, 1u);
  EXPECT_EQ(surface.points.size(), before.points.size() + report.splits);
  EXPECT_TRUE(std::equal(before.points.begin(), before.points.end(), surface.points.begin()));
  EXPECT_EQ(surface.points[before.points.size()], (Vector3{ 0.4, 0, 0 }));
  expectClosed(surface);
  EXPECT_TRUE(findIntersections(surface).empty());
  EXPECT_NEAR(enclosedVolume(surface), 0.001, 1e-16);
  for (int patch = 1; patch <= 6; ++patch)
  {
    EXPECT_NEAR(areaOfPatch(surface, patch), areaOfPatch(before, patch), 1e-15) << patch;
  }
}

TEST(FlatTriangles, AreNotSplitInWhatIsToBeKept)
{
  SurfaceMesh surface = bar(0.01);
  std::vector<char> keep(surface.points.size(), 0);
  keep[0] = keep[1] = 1;
  EXPECT_EQ(splitFlatTriangles(surface, keep), 0u);
  EXPECT_EQ(mendFlatTriangles(surface, 10, keep).flatAfter, 1u);
}

TEST(FlatTriangles, AreAllThatIsTouched)
{
  SurfaceMesh surface = bar(0.3);
  const auto triangles = surface.triangles;
  const FlatTriangleReport report = mendFlatTriangles(surface, 10);
  EXPECT_EQ(report.swaps + report.splits, 0u);
  EXPECT_EQ(report.largestAfter, report.largestBefore);
  EXPECT_EQ(surface.triangles, triangles);
}

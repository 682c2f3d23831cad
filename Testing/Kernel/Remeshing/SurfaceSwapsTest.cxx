#include "Remeshing/SurfaceSwaps.h"

#include "Domain/SurfaceSizes.h"
#include "Triangles/SurfaceEdges.h"
#include "Triangles/SurfaceIntersections.h"
#include "Triangles/SurfaceRepair.h"
#include "Triangles/SurfaceTriangles.h"

#include <gtest/gtest.h>

#include <random>

namespace
{
using namespace ransmesh;

constexpr int Count = 8;      // parts of each row
constexpr double Width = 0.1; // of a strip

// Two rows of points, at y = 0 and y = Width, x from 0 to 1, on the surface z = -bend x^2. All points of the
// first row are joined to the first point of the second one, and all of the second to the last of the first.
SurfaceMesh fans(double bend)
{
  SurfaceMesh surface;
  for (int row = 0; row < 2; ++row)
  {
    for (int i = 0; i <= Count; ++i)
    {
      const double x = static_cast<double>(i) / Count;
      surface.points.push_back({ x, row * Width, -bend * x * x });
    }
  }
  for (Index i = 0; i < Count; ++i)
  {
    surface.triangles.push_back({ i, i + 1, Count + 1 });
    surface.triangles.push_back({ Count, Count + 2 + i, Count + 1 + i });
  }
  surface.patch.assign(surface.triangles.size(), 1);
  return surface;
}

// Two triangles on a square with a short and a long diagonal, of which the long one is there. The corner at
// the low end of the short one lies `lift` lower.
SurfaceMesh lozenge(double lift)
{
  return { { { -1, 0, 0 }, { 1, 0, 0 }, { 0, 0.1, 0 }, { 0, -0.1, -lift } }, { { 0, 1, 2 }, { 1, 0, 3 } },
    { 1, 1 } };
}

double worstAngle(const SurfaceMesh& surface)
{
  double worst = 0;
  for (const Corners& t : surface.triangles)
  {
    worst = std::fmax(worst, largestAngle(surface, t));
  }
  return worst;
}

double areaOf(const SurfaceMesh& surface)
{
  double twice = 0;
  for (const Corners& t : surface.triangles)
  {
    twice += norm(areaVector(surface, t));
  }
  return 0.5 * twice;
}

// Each edge has as many triangles as before, one on each side where there are two.
void expectSameTopology(const SurfaceMesh& surface, std::size_t openEdges)
{
  std::size_t open = 0;
  forEachEdge(sortedEdges(surface),
    [&](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      open += last - first == 1 ? 1 : 0;
      EXPECT_LE(last - first, 2);
      EXPECT_TRUE(last - first == 1 || first[0].forward != first[1].forward);
    });
  EXPECT_EQ(open, openEdges);
}

// A cube of Count x Count x 2 triangles a side, each side a patch.
SurfaceMesh cube()
{
  SurfaceMesh surface;
  for (int side = 0; side < 6; ++side)
  {
    const int axis = side / 2;
    const auto first = static_cast<Index>(surface.points.size());
    for (int j = 0; j <= Count; ++j)
    {
      for (int i = 0; i <= Count; ++i)
      {
        Vector3 p;
        p[axis] = side % 2;
        p[(axis + 1) % 3] = static_cast<double>(i) / Count;
        p[(axis + 2) % 3] = static_cast<double>(j) / Count;
        surface.points.push_back(p);
      }
    }
    for (int j = 0; j < Count; ++j)
    {
      for (int i = 0; i < Count; ++i)
      {
        const Index a = first + j * (Count + 1) + i;
        const Index c = a + Count + 2;
        for (Corners t : { Corners{ a, a + 1, c }, Corners{ a, c, c - 1 } })
        {
          if (side % 2 == 0)
          {
            std::swap(t[1], t[2]);
          }
          surface.triangles.push_back(t);
          surface.patch.push_back(side + 1);
        }
      }
    }
  }
  mergeEqualPoints(surface);
  return surface;
}

// Swaps at random within the sides, where the two triangles are convex together, however bad they become.
void spoil(SurfaceMesh& surface, std::uint32_t seed)
{
  std::mt19937 random(seed);
  for (int pass = 0; pass < 20; ++pass)
  {
    const auto edges = sortedEdges(surface);
    const std::size_t e = random() % (edges.size() / 3) * 3;
    std::vector<char> isUsed(surface.triangles.size(), 0);
    for (std::size_t i = e; i + 1 < edges.size(); ++i)
    {
      const Index s = edges[i].triangle;
      const Index t = edges[i + 1].triangle;
      if (!edges[i].sameEdge(edges[i + 1]) || surface.patch[s] != surface.patch[t] || isUsed[s] ||
        isUsed[t] || random() % 2)
      {
        continue;
      }
      const auto opposite = [&](Index triangle)
      {
        const Corners& v = surface.triangles[triangle];
        return *std::find_if(v.begin(), v.end(), [&](Index x) { return x != edges[i].a && x != edges[i].b; });
      };
      const Index from = edges[i].forward ? edges[i].a : edges[i].b;
      const Index to = edges[i].forward ? edges[i].b : edges[i].a;
      const Corners first = { opposite(s), opposite(t), to };
      const Corners second = { opposite(t), opposite(s), from };
      const Vector3 old = areaVector(surface, surface.triangles[s]);
      constexpr double notFlat = 1e-12;
      if (dot(areaVector(surface, first), old) > notFlat && dot(areaVector(surface, second), old) > notFlat)
      {
        surface.triangles[s] = first;
        surface.triangles[t] = second;
        isUsed[s] = isUsed[t] = 1;
      }
    }
  }
}
} // namespace

TEST(SurfaceSwaps, MakeGoodTrianglesOfFansOfNeedles)
{
  SurfaceMesh surface = fans(0);
  const SurfaceMesh before = surface;
  const SwapReport report = swapDiagonals(surface, 10);
  EXPECT_GT(report.largestBefore, 173);
  EXPECT_LT(report.largestAfter, ObtuseTriangleAngle);
  EXPECT_DOUBLE_EQ(report.largestAfter, worstAngle(surface));
  EXPECT_GT(report.swaps, 6u);
  EXPECT_LT(report.largestShift, 1e-15);
  EXPECT_EQ(surface.points, before.points);
  EXPECT_NEAR(areaOf(surface), Width, 1e-15);
  expectSameTopology(surface, 2 * Count + 2);
}

TEST(SurfaceSwaps, LeaveGoodSurfacesAlone)
{
  SurfaceMesh surface = cube();
  const auto triangles = surface.triangles;
  EXPECT_EQ(swapDiagonals(surface, 10).swaps, 0u);
  EXPECT_EQ(surface.triangles, triangles);
}

TEST(SurfaceSwaps, TurnCurvedSurfacesByNoMoreThanTheAngle)
{
  SurfaceMesh surface = fans(0.004);
  const SwapReport report = swapDiagonals(surface, 10);
  EXPECT_LT(report.largestAfter, ObtuseTriangleAngle);
  EXPECT_GT(report.largestShift, 1e-6);
  EXPECT_LT(report.largestShift, 0.001); // the sagitta
  for (const Corners& t : surface.triangles)
  {
    const double x = surface.points[t[0]].x;
    EXPECT_LT(degreesBetween(areaVector(surface, t), { 0.008 * x, 0, 1 }), 5);
  }
  surface = fans(0.004);
  EXPECT_EQ(swapDiagonals(surface, 0.01).swaps, 0u);
}

TEST(SurfaceSwaps, KeepRidges)
{
  SurfaceMesh plane = lozenge(0);
  EXPECT_EQ(swapDiagonals(plane, 10).swaps, 1u);
  EXPECT_LT(worstAngle(plane), 90);
  SurfaceMesh ridge = lozenge(0.1); // 45 degrees
  EXPECT_EQ(swapDiagonals(ridge, 20).swaps, 0u);
  EXPECT_EQ(swapDiagonals(ridge, 30).swaps, 1u);
  EXPECT_GT(areaOf(ridge), 0.2);
}

TEST(SurfaceSwaps, KeepBordersOfPatchesAndWhatIsToBeKept)
{
  SurfaceMesh border = lozenge(0);
  border.patch = { 1, 2 };
  EXPECT_EQ(swapDiagonals(border, 10).swaps, 0u);
  SurfaceMesh kept = lozenge(0);
  EXPECT_EQ(swapDiagonals(kept, 10, { 1, 1, 0, 0 }).swaps, 0u);
  EXPECT_EQ(swapDiagonals(kept, 10, { 1, 0, 1, 1 }).swaps, 1u);
}

TEST(SurfaceSwaps, MakeNoEdgeTwice)
{
  SurfaceMesh flat = lozenge(0.001);
  flat.triangles.insert(flat.triangles.end(), { { 2, 3, 0 }, { 3, 2, 1 } });
  flat.patch = { 1, 1, 1, 1 };
  EXPECT_EQ(swapDiagonals(flat, 30).swaps, 0u);
  expectSameTopology(flat, 0);
}

TEST(SurfaceSwaps, MoveTrianglesOnALineToTheOtherSideOfARidge)
{
  // Point 2 stands on the ridge from 0 to 1 but for rounding; the wall below knows nothing of it.
  SurfaceMesh surface = { { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1e-9, 0 }, { 0.5, 1, 0 }, { 0.5, 0, -1 } },
    { { 0, 1, 2 }, { 0, 2, 3 }, { 2, 1, 3 }, { 1, 0, 4 } }, { 1, 1, 1, 1 } };
  const SwapReport report = swapDiagonals(surface, 10);
  EXPECT_EQ(report.swaps, 1u);
  EXPECT_LT(report.largestAfter, 95);
  expectSameTopology(surface, 4);
}

TEST(SurfaceSwaps, DoNotMakeTheSurfaceCutItself)
{
  // A needle stands through the place that the surface would take.
  SurfaceMesh surface = lozenge(0.02);
  const SurfaceMesh needle = { { { 0.0, 0.001, -0.005 }, { 0.001, -0.001, -0.005 },
                                 { -0.001, -0.001, -0.005 }, { 0, 0, -0.05 } },
    { { 4, 6, 5 }, { 4, 5, 7 }, { 5, 6, 7 }, { 6, 4, 7 } }, { 2, 2, 2, 2 } };
  surface.points.insert(surface.points.end(), needle.points.begin(), needle.points.end());
  surface.triangles.insert(surface.triangles.end(), needle.triangles.begin(), needle.triangles.end());
  surface.patch.insert(surface.patch.end(), needle.patch.begin(), needle.patch.end());
  ASSERT_TRUE(findIntersections(surface).empty());
  EXPECT_EQ(swapDiagonals(surface, 30).swaps, 0u);
  EXPECT_TRUE(findIntersections(surface).empty());
  SurfaceMesh alone = lozenge(0.02);
  EXPECT_EQ(swapDiagonals(alone, 30).swaps, 1u);
}

TEST(SurfaceSwaps, MendSpoiledCubesWhateverTheyLookLike)
{
  for (std::uint32_t seed = 0; seed < 20; ++seed)
  {
    SurfaceMesh surface = cube();
    spoil(surface, seed);
    const SurfaceMesh before = surface;
    const SwapReport report = swapDiagonals(surface, 10);
    EXPECT_LE(report.largestAfter, report.largestBefore) << seed;
    EXPECT_EQ(report.largestBefore > ObtuseTriangleAngle, report.swaps > 0) << seed;
    EXPECT_LE(report.largestAfter, ObtuseTriangleAngle) << seed;
    EXPECT_EQ(surface.points, before.points) << seed;
    EXPECT_EQ(surface.patch, before.patch) << seed;
    EXPECT_NEAR(areaOf(surface), 6, 1e-12) << seed;
    EXPECT_NEAR(enclosedVolume(surface), 1, 1e-12) << seed;
    EXPECT_TRUE(findIntersections(surface).empty()) << seed;
    expectSameTopology(surface, 0);
    SurfaceMesh again = before;
    swapDiagonals(again, 10);
    EXPECT_EQ(again.triangles, surface.triangles) << seed;
  }
}

#include "Remeshing/EditableSurface.h"
#include "Remeshing/SurfaceReference.h"

#include "Geometry/Distance.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

using namespace ransmesh;

namespace
{
// Squares of n by n in the plane z = 0, two triangles each; the left half is patch 1, the rest patch 2.
SurfaceMesh lattice(int n)
{
  SurfaceMesh surface;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      surface.points.push_back({ static_cast<double>(i), static_cast<double>(j), 0 });
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const Index a = j * (n + 1) + i;
      const Index d = a + n + 1;
      surface.triangles.push_back({ a, a + 1, d + 1 });
      surface.triangles.push_back({ a, d + 1, d });
      surface.patch.insert(surface.patch.end(), 2, 2 * i < n ? 1 : 2);
    }
  }
  return surface;
}

double areaOf(const SurfaceMesh& surface, int patch)
{
  double area = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    area += surface.patch[t] == patch ? areaVector(surface, surface.triangles[t]).z / 2 : 0;
  }
  return area;
}

constexpr Index Middle = 12; // of 4 by 4 squares
} // namespace

TEST(EditableSurface, NamesLinesFromEndToEnd)
{
  const EditableSurface surface(lattice(4), 30);
  EXPECT_EQ(surface.freedom(6), PointFreedom::Surface);
  EXPECT_EQ(surface.freedom(Middle), PointFreedom::Line); // the border of the patches
  EXPECT_EQ(surface.freedom(1), PointFreedom::Line);      // the border of the surface
  EXPECT_EQ(surface.freedom(0), PointFreedom::Fixed);
  EXPECT_EQ(surface.freedom(2), PointFreedom::Fixed); // where the two meet
  EXPECT_EQ(surface.lineCount(), 7);
  EXPECT_EQ(surface.lineOf(2, 7), surface.lineOf(17, 22));
  EXPECT_EQ(surface.lineOf(0, 1), surface.lineOf(1, 2));
  EXPECT_NE(surface.lineOf(1, 2), surface.lineOf(2, 3));
  EXPECT_EQ(surface.lineOf(6, 7), None);
}

TEST(EditableSurface, AllowsOnlyCollapsesThatKeepLines)
{
  EditableSurface surface(lattice(4), 30);
  EXPECT_TRUE(surface.mayCollapse(6, Middle));
  EXPECT_FALSE(surface.mayCollapse(Middle, 6)); // it would leave its line
  EXPECT_TRUE(surface.mayCollapse(Middle, 17));
  EXPECT_FALSE(surface.mayCollapse(0, 1)); // a corner
  surface.collapse(Middle, 17);
  EXPECT_EQ(surface.lineOf(7, 17), surface.lineOf(2, 7));
  const SurfaceMesh made = surface.result();
  EXPECT_EQ(made.triangles.size(), 30u);
  EXPECT_EQ(made.points.size(), 24u);
  EXPECT_DOUBLE_EQ(areaOf(made, 1), 8);
  EXPECT_DOUBLE_EQ(areaOf(made, 2), 8);
}

TEST(EditableSurface, SplitsAndSwapsKeepPatchesAndNeighbours)
{
  EditableSurface surface(lattice(4), 30);
  const Index middle = surface.split(7, Middle, { 2, 1.5, 0 });
  EXPECT_EQ(surface.freedom(middle), PointFreedom::Line);
  EXPECT_EQ(surface.trianglesAt(middle).size(), 4u);
  std::array<Corners, 2> made;
  EXPECT_FALSE(surface.maySwap(7, middle, made)); // on a line
  ASSERT_TRUE(surface.maySwap(0, 6, made));
  surface.swap(0, 6);
  EXPECT_EQ(surface.neighbours(0), (std::vector<Index>{ 1, 5 }));
  EXPECT_EQ(surface.trianglesAt(1, 5).size(), 2u);
  EXPECT_DOUBLE_EQ(areaOf(surface.result(), 1), 8);
  EXPECT_DOUBLE_EQ(areaOf(surface.result(), 2), 8);
}

TEST(EditableSurface, LeavesKeptPointsAlone)
{
  std::vector<char> keep(25, 0);
  keep[6] = keep[Middle] = 1;
  const EditableSurface surface(lattice(4), 30, keep);
  EXPECT_FALSE(surface.mayCollapse(6, 7));
  EXPECT_FALSE(surface.maySplit(6, Middle));
  EXPECT_TRUE(surface.maySplit(6, 7));
  std::array<Corners, 2> made;
  EXPECT_FALSE(surface.maySwap(6, Middle, made));
}

TEST(SurfaceReference, FindsTheClosestTriangle)
{
  SurfaceMesh surface;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(0, 1);
  for (Index t = 0; t < 200; ++t)
  {
    // Needles: two corners near each other, the third far away.
    const Vector3 a{ number(random), number(random), number(random) };
    surface.points.push_back(a);
    surface.points.push_back(a + 1e-3 * Vector3{ number(random), number(random), number(random) });
    surface.points.push_back({ number(random), number(random), number(random) });
    surface.triangles.push_back({ 3 * t, 3 * t + 1, 3 * t + 2 });
    surface.patch.push_back(1 + t % 2);
  }
  std::vector<Index> all(surface.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  const TriangleTree tree(surface, all);
  for (int i = 0; i < 300; ++i)
  {
    const Vector3 p{ 2 * number(random), 2 * number(random), 2 * number(random) };
    double least = INFINITY;
    for (const Corners& t : surface.triangles)
    {
      least = std::min(
        least, distanceToTriangle(p, surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]));
    }
    Vector3 q = p;
    ASSERT_NE(tree.closest(q), None);
    EXPECT_NEAR(distance(p, q), least, 1e-12);
  }
}

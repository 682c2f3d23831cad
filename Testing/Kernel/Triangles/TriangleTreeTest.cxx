// A tree of boxes around triangles.
#include "Triangles/TriangleTree.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

using namespace ransmesh;

TEST(TriangleTree, VisitsOnceWhatMeetsABox)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(0, 1);
  const auto anywhere = [&] { return Vector3{ number(random), number(random), number(random) }; };
  SurfaceMesh surface;
  for (Index t = 0; t < 300; ++t)
  {
    const Vector3 a = anywhere();
    surface.points.insert(surface.points.end(), { a, a + 0.1 * anywhere(), a + 0.1 * anywhere() });
    surface.triangles.push_back({ 3 * t, 3 * t + 1, 3 * t + 2 });
  }
  std::vector<Index> all(surface.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  const TriangleTree tree(surface, all);
  int passedOver = 0;
  for (int i = 0; i < 100; ++i)
  {
    const Vector3 low = anywhere();
    const Extent box{ low, low + 0.3 * anywhere() };
    std::vector<int> visits(all.size(), 0);
    tree.visitMeeting(box, [&visits](Index t) { ++visits[t]; });
    for (const Index t : all)
    {
      Extent own{ surface.points[3 * t], surface.points[3 * t] };
      own.add(surface.points[3 * t + 1]);
      own.add(surface.points[3 * t + 2]);
      EXPECT_LE(visits[t], 1);
      EXPECT_TRUE(visits[t] == 1 || !own.meets(box));
      passedOver += visits[t] == 0;
    }
  }
  EXPECT_GT(passedOver, 15000); // of 30 000: it does not visit all
}

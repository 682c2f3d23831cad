#include "Triangles/SurfaceIntersections.h"

#include "Triangles/TriangleBoxes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>

namespace ransmesh
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

class PairTest
{
public:
  explicit PairTest(const SurfaceMesh& surface)
    : surface_(surface)
  {
  }

  bool meetWrongly(Index first, Index second) const
  {
    const auto& s = surface_.triangles[first];
    const auto& t = surface_.triangles[second];
    int i = 0; // with one shared point: its place in s and t; with two: the places of the others
    int j = 0;
    switch (sharedPoints(s, t, i, j))
    {
      case 0:
        return CGAL::do_intersect(triangle(s), triangle(t));
      case 1:
        return CGAL::do_intersect(triangle(s), oppositeSide(t, j)) ||
          CGAL::do_intersect(triangle(t), oppositeSide(s, i));
      case 2:
        return folded(s, t, i, j);
      default:
        return false;
    }
  }

private:
  Kernel::Point_3 point(Index v) const
  {
    const Vector3& p = surface_.points[v];
    return { p.x, p.y, p.z };
  }
  Kernel::Triangle_3 triangle(const std::array<Index, 3>& t) const
  {
    return { point(t[0]), point(t[1]), point(t[2]) };
  }
  Kernel::Segment_3 oppositeSide(const std::array<Index, 3>& t, int corner) const
  {
    return { point(t[(corner + 1) % 3]), point(t[(corner + 2) % 3]) };
  }

  static int sharedPoints(const std::array<Index, 3>& s, const std::array<Index, 3>& t, int& i, int& j)
  {
    int count = 0;
    int sumS = 0;
    int sumT = 0;
    for (int a = 0; a < 3; ++a)
    {
      for (int b = 0; b < 3; ++b)
      {
        if (s[a] == t[b])
        {
          ++count;
          sumS += a;
          sumT += b;
        }
      }
    }
    i = count == 1 ? sumS : 3 - sumS;
    j = count == 1 ? sumT : 3 - sumT;
    return count;
  }

  // Two triangles at one edge overlap only where they lie in one plane, on the same side of the edge.
  bool folded(const std::array<Index, 3>& s, const std::array<Index, 3>& t, int i, int j) const
  {
    const auto a = point(s[(i + 1) % 3]);
    const auto b = point(s[(i + 2) % 3]);
    const auto c = point(s[i]);
    const auto d = point(t[j]);
    return CGAL::coplanar(a, b, c, d) && CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE;
  }

  const SurfaceMesh& surface_;
};
} // namespace

std::vector<std::pair<Index, Index>> findIntersections(const SurfaceMesh& surface, std::size_t limit)
{
  std::vector<TriangleBox> boxes = boxesAround(surface);
  const PairTest test(surface);
  std::vector<std::pair<Index, Index>> pairs;
  const auto examine = [&](const TriangleBox& x, const TriangleBox& y)
  {
    const auto s = static_cast<Index>(x.handle() - surface.triangles.data());
    const auto t = static_cast<Index>(y.handle() - surface.triangles.data());
    if (pairs.size() < limit && test.meetWrongly(s, t))
    {
      pairs.emplace_back(std::min(s, t), std::max(s, t));
    }
  };
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), examine);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}
} // namespace ransmesh

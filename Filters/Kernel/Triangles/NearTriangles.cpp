#include "Triangles/NearTriangles.h"

#include "Geometry/Distance.h"
#include "Triangles/TriangleBoxes.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
constexpr double PartOfEdge = 0.1;

class NearTest
{
public:
  NearTest(const SurfaceMesh& surface, double distance)
    : surface_(surface)
    , distance_(distance)
  {
  }

  bool isNear(Index s, Index t) const
  {
    const auto& u = surface_.triangles[s];
    const auto& v = surface_.triangles[t];
    for (const Index corner : u)
    {
      if (corner == v[0] || corner == v[1] || corner == v[2])
      {
        return false;
      }
    }
    const double limit = std::min({ distance_, PartOfEdge * shortestSide(u), PartOfEdge * shortestSide(v) });
    return comesWithin(limit, u, v) || comesWithin(limit, v, u);
  }

private:
  double shortestSide(const std::array<Index, 3>& t) const
  {
    const auto& p = surface_.points;
    return std::min({ distance(p[t[0]], p[t[1]]), distance(p[t[1]], p[t[2]]), distance(p[t[2]], p[t[0]]) });
  }

  bool comesWithin(double limit, const std::array<Index, 3>& u, const std::array<Index, 3>& v) const
  {
    const auto& p = surface_.points;
    return std::any_of(u.begin(), u.end(),
      [&](Index c) { return distanceToTriangle(p[c], p[v[0]], p[v[1]], p[v[2]]) <= limit; });
  }

  const SurfaceMesh& surface_;
  double distance_;
};
} // namespace

std::vector<std::pair<Index, Index>> findNearTriangles(
  const SurfaceMesh& surface, double distance, std::size_t limit)
{
  std::vector<TriangleBox> boxes = boxesAround(surface, distance / 2);
  const NearTest test(surface, distance);
  std::vector<std::pair<Index, Index>> pairs;
  const auto examine = [&](const TriangleBox& x, const TriangleBox& y)
  {
    const auto s = static_cast<Index>(x.handle() - surface.triangles.data());
    const auto t = static_cast<Index>(y.handle() - surface.triangles.data());
    if (pairs.size() < limit && test.isNear(s, t))
    {
      pairs.emplace_back(std::min(s, t), std::max(s, t));
    }
  };
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), examine);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}
} // namespace ransmesh

#include "Bodies/CrossedTriangles.h"

#include <algorithm>
#include <array>

namespace bodies
{
namespace
{
using ransmesh::Index;
using ransmesh::SurfaceMesh;
using ransmesh::Vector3;
using Corners = std::array<Vector3, 3>;

constexpr double Zero = 1e-12;

Corners cornersOf(const SurfaceMesh& surface, std::size_t triangle)
{
  const auto& v = surface.triangles[triangle];
  return { surface.points[v[0]], surface.points[v[1]], surface.points[v[2]] };
}

// Six times the volume of a tetrahedron, as a sign.
int side(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  const double volume = dot(cross(b - a, c - a), d - a);
  return (volume > Zero) - (volume < -Zero);
}

bool passesThrough(const Vector3& p, const Vector3& q, const Corners& t)
{
  if (side(t[0], t[1], t[2], p) * side(t[0], t[1], t[2], q) >= 0)
  {
    return false;
  }
  const int first = side(p, q, t[0], t[1]);
  return first != 0 && first == side(p, q, t[1], t[2]) && first == side(p, q, t[2], t[0]);
}

bool anEdgePassesThrough(const Corners& edges, const Corners& triangle)
{
  for (int i = 0; i < 3; ++i)
  {
    if (passesThrough(edges[i], edges[(i + 1) % 3], triangle))
    {
      return true;
    }
  }
  return false;
}

// Of triangles in one plane: whether a line along an edge of `edges` has them on its two sides.
bool anEdgeParts(const Corners& edges, const Corners& other)
{
  const Vector3 normal = cross(edges[1] - edges[0], edges[2] - edges[0]);
  for (int i = 0; i < 3; ++i)
  {
    const Vector3 inward = cross(normal, edges[(i + 1) % 3] - edges[i]);
    const auto isOutside = [&](const Vector3& p) { return dot(inward, p - edges[i]) <= Zero; };
    if (std::all_of(other.begin(), other.end(), isOutside))
    {
      return true;
    }
  }
  return false;
}

bool overlapInAPlane(const Corners& s, const Corners& t)
{
  const auto isInPlane = [&s](const Vector3& p) { return side(s[0], s[1], s[2], p) == 0; };
  return std::all_of(t.begin(), t.end(), isInPlane) && !anEdgeParts(s, t) && !anEdgeParts(t, s);
}
} // namespace

std::set<Index> crossedTriangles(const SurfaceMesh& surface)
{
  std::set<Index> all;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    const Corners s = cornersOf(surface, i);
    for (std::size_t j = i + 1; j < surface.triangles.size(); ++j)
    {
      const Corners t = cornersOf(surface, j);
      if (anEdgePassesThrough(s, t) || anEdgePassesThrough(t, s) || overlapInAPlane(s, t))
      {
        all.insert({ static_cast<Index>(i), static_cast<Index>(j) });
      }
    }
  }
  return all;
}
} // namespace bodies

#include "Geometry/Distance.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
Vector3 closestPointOnSegment(const Vector3& p, const Vector3& a, const Vector3& b)
{
  const Vector3 along = b - a;
  const double lengthSquared = dot(along, along);
  const double t = lengthSquared > 0 ? std::clamp(dot(p - a, along) / lengthSquared, 0.0, 1.0) : 0.0;
  return a + t * along;
}

double squaredDistance(const Vector3& a, const Vector3& b)
{
  return dot(a - b, a - b);
}
} // namespace

Vector3 closestPointOnTriangle(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c)
{
  // Barycentric coordinates of p's projection, times the area: where one is negative, p is beyond an edge.
  const Vector3 ab = b - a;
  const Vector3 ac = c - a;
  const Vector3 ap = p - a;
  const Vector3 normal = cross(ab, ac);
  const double area = dot(normal, normal);
  if (area > 0)
  {
    const double v = dot(cross(ap, ac), normal);
    const double w = dot(cross(ab, ap), normal);
    const bool beyondAc = v < 0;
    const bool beyondAb = w < 0;
    const bool beyondBc = v + w > area;
    if (!beyondAc && !beyondAb && !beyondBc)
    {
      return a + (v / area) * ab + (w / area) * ac;
    }
    if (beyondAc + beyondAb + beyondBc == 1)
    {
      return beyondAc ? closestPointOnSegment(p, a, c)
        : beyondAb    ? closestPointOnSegment(p, a, b)
                      : closestPointOnSegment(p, b, c);
    }
  }
  Vector3 best = closestPointOnSegment(p, a, b);
  for (const Vector3& candidate : { closestPointOnSegment(p, b, c), closestPointOnSegment(p, c, a) })
  {
    if (squaredDistance(p, candidate) < squaredDistance(p, best))
    {
      best = candidate;
    }
  }
  return best;
}
} // namespace ransmesh

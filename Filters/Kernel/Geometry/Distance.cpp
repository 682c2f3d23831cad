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
} // namespace

Vector3 closestPointOnTriangle(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c)
{
  // Barycentric coordinates of p's projection; where one is negative, the closest point lies on an edge.
  const Vector3 ab = b - a;
  const Vector3 ac = c - a;
  const Vector3 ap = p - a;
  const Vector3 normal = cross(ab, ac);
  const double area = dot(normal, normal);
  if (area > 0)
  {
    const double v = dot(cross(ap, ac), normal) / area;
    const double w = dot(cross(ab, ap), normal) / area;
    if (v >= 0 && w >= 0 && v + w <= 1)
    {
      return a + v * ab + w * ac;
    }
  }
  Vector3 best = closestPointOnSegment(p, a, b);
  for (const Vector3& candidate : { closestPointOnSegment(p, b, c), closestPointOnSegment(p, c, a) })
  {
    if (distance(p, candidate) < distance(p, best))
    {
      best = candidate;
    }
  }
  return best;
}
} // namespace ransmesh

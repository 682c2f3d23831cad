// Distances between points and simplices.
#pragma once

#include "Geometry/Vector3.h"

namespace ransmesh
{
// The point of the triangle (a, b, c) that is closest to p. A degenerate triangle counts as its edges.
Vector3 closestPointOnTriangle(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c);

inline double distanceToTriangle(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c)
{
  return distance(p, closestPointOnTriangle(p, a, b, c));
}
} // namespace ransmesh

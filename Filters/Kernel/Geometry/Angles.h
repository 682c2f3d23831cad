// Angles, in degrees.
#pragma once

#include "Geometry/Vector3.h"

#include <algorithm>

namespace ransmesh
{
inline constexpr double DegreesOfRadian = 57.29577951308232;

inline double cosineOfDegrees(double angle)
{
  return std::cos(angle / DegreesOfRadian);
}

// 0 to 180; sound near both ends, where an arc cosine is not.
inline double degreesBetween(const Vector3& a, const Vector3& b)
{
  return DegreesOfRadian * std::atan2(norm(cross(a, b)), dot(a, b));
}

// The largest angle of a triangle.
inline double largestAngle(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const double atA = degreesBetween(b - a, c - a);
  const double atB = degreesBetween(c - b, a - b);
  return std::max({ atA, atB, 180 - atA - atB });
}
} // namespace ransmesh

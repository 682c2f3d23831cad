// A triangle, made ready to be seen from many places.
#pragma once

#include "Geometry/Vector3.h"

#include <cmath>

namespace ransmesh
{
// What six volumes and the squares of the edges of the tetrahedron from a triangle to any place need: a quality
// costs a fifth of what it costs from four points. Corners and places are to be given as seen from a point nearby.
class FaceView
{
public:
  FaceView() = default;
  FaceView(const Vector3& a, const Vector3& b, const Vector3& c)
  {
    const Vector3 ab = b - a;
    const Vector3 ac = c - a;
    const Vector3 bc = c - b;
    normal_ = cross(ab, ac);
    offset_ = dot(normal_, a);
    sum_ = a + b + c;
    squares_ = dot(ab, ab) + dot(ac, ac) + dot(bc, bc) + dot(a, a) + dot(b, b) + dot(c, c);
  }

  // The square, with its sign, of the quality (Geometry/TetrahedronMeasures.h) from the apex. Rounded: exact
  // positivity is for the caller to check.
  double signedSquare(const Vector3& apex, double squareOfApex) const
  {
    const double sixVolume = dot(normal_, apex) - offset_;
    const double squares = squares_ + 3 * squareOfApex - 2 * dot(sum_, apex); // of all six edges
    constexpr double regular = 432; // that of the regular tetrahedron is 1
    return regular * sixVolume * std::fabs(sixVolume) / (squares * squares * squares);
  }

private:
  Vector3 normal_; // twice the area
  double offset_ = 0;
  Vector3 sum_;        // of the corners' places
  double squares_ = 0; // of the edges and of the corners' places
};

inline double signedRoot(double square)
{
  return square < 0 ? -std::sqrt(-square) : std::sqrt(square);
}
} // namespace ransmesh

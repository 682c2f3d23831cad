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

  // The same from corners whose squares are known: those of the edges follow from them and from the sum.
  FaceView(const Vector3& a, const Vector3& b, const Vector3& c, double squaresOfCorners)
    : normal_(cross(b - a, c - a))
    , offset_(dot(normal_, a))
    , sum_(a + b + c)
    , squares_(4 * squaresOfCorners - dot(sum_, sum_))
  {
  }

  // Six times the volume from the apex, rounded.
  double sixVolume(const Vector3& apex) const { return dot(normal_, apex) - offset_; }

  // The square, with its sign, of the quality (Geometry/TetrahedronMeasures.h) from the apex. Rounded: exact
  // positivity is for the caller to check.
  double signedSquare(const Vector3& apex, double squareOfApex) const
  {
    const double volume = sixVolume(apex);
    const double squares = squaresOfEdges(apex, squareOfApex);
    return Regular * volume * std::fabs(volume) / (squares * squares * squares);
  }

private:
  static constexpr double Regular = 432; // so that it is 1 for the regular tetrahedron

  double squaresOfEdges(const Vector3& apex, double squareOfApex) const
  {
    return squares_ + 3 * squareOfApex - 2 * dot(sum_, apex);
  }

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

// Measures of one tetrahedron's shape. Angles are in degrees, lengths in the unit of the points.
#pragma once

#include "Geometry/Predicates.h"

#include <algorithm>
#include <array>
#include <limits>

namespace ransmesh
{
// Volume over the cube of the root-mean-square edge, 1 for the regular tetrahedron. Not above 0 exactly
// when the tetrahedron is not positive in exact arithmetic.
inline double quality(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  const Vector3 u = b - a;
  const Vector3 v = c - a;
  const Vector3 w = d - a;
  const Vector3 vu = v - u;
  const Vector3 wu = w - u;
  const Vector3 wv = w - v;
  const double meanSquare = (dot(u, u) + dot(v, v) + dot(w, w) + dot(vu, vu) + dot(wu, wu) + dot(wv, wv)) / 6;
  const double scale = meanSquare * std::sqrt(meanSquare);
  if (!(scale > 0))
  {
    return 0;
  }
  constexpr double regular = 1.4142135623730951; // (edge cubed) / (six volumes) of the regular one
  const double value = regular * dot(cross(u, v), w) / scale;
  // Rounding can turn the sign only below this: Shewchuk's bound times the largest permanent.
  constexpr double certain = 1e-13;
  if (std::fabs(value) > certain)
  {
    return value;
  }
  const int sign = orientation(a, b, c, d);
  return sign > 0 ? std::max(std::fabs(value), 1e-300) : -std::fabs(value);
}

// The edges of a tetrahedron, by corners, in the order in which the functions below give theirs.
inline constexpr int EdgeCorners[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };

// The six angles between faces, one at each edge, 0 to 180; sound for heights of 1e-8 of the edges and less.
std::array<double, 6> dihedralAngles(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d);

// The largest of them.
double largestDihedral(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d);

// How exactly a shape has to be known: one that is not above floor may be given as anything not above it, and
// one above ceiling as anything above that.
struct ShapeRange
{
  double floor = 0;
  double ceiling = std::numeric_limits<double>::infinity();
};

// A measure of shape, larger for better: what the operators that improve a mesh compare.
using ShapeMeasure = double (*)(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d, const ShapeRange& range);

// The quality as such a measure.
inline double plainQuality(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d, const ShapeRange&)
{
  return quality(a, b, c, d);
}

// Four times the quality, or one plus the cosine of the largest angle where that is less: flat caps, which quality
// alone forgives, count as bad (0.13 at 150 degrees, 0.004 at 175), needles, which do no harm and which narrow
// triangles make everywhere, only where they are very thin.
double angleQuality(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d, const ShapeRange& range = {});

struct TetrahedronMeasures
{
  double volume = 0; // signed, rounded
  double quality = 0;
  double longestEdge = 0;
  double shortestEdge = 0;
  double smallestHeight = 0;
  double largestDihedral = 0;
  double smallestDihedral = 0;

  // Longest edge over smallest height: 1.22 for the regular one. Finite also for a flat one.
  double stretching() const;
};

TetrahedronMeasures measure(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d);
} // namespace ransmesh

#include "Geometry/TetrahedronMeasures.h"

#include "Geometry/Angles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ransmesh
{
namespace
{
// The corners that are not on the edge.
constexpr int OppositeCorners[6][2] = { { 2, 3 }, { 1, 3 }, { 1, 2 }, { 0, 3 }, { 0, 2 }, { 0, 1 } };

// An angle as sine and cosine, both scaled by the same positive number and by the volume. The faces'
// normals at an edge e have the vector product e * (six volumes): so the sine needs no difference of
// nearly parallel normals, and the six angles of a tetrahedron share one volume.
struct ScaledAngle
{
  double edge; // sine over six volumes
  double cosine;

  double cotangent() const { return cosine / edge; } // times six volumes
  double degrees(double sixVolume) const { return DegreesOfRadian * std::atan2(edge * sixVolume, cosine); }
};

ScaledAngle angleAt(const std::array<Vector3, 4>& p, int edge)
{
  const Vector3& from = p[EdgeCorners[edge][0]];
  const Vector3 e = p[EdgeCorners[edge][1]] - from;
  const Vector3 one = cross(e, p[OppositeCorners[edge][0]] - from);
  const Vector3 other = cross(e, p[OppositeCorners[edge][1]] - from);
  return { norm(e), dot(one, other) };
}

struct AngleRange
{
  double smallest;
  double largest;
};

// Cotangents order the angles, and need no volume: two arc tangents instead of six.
AngleRange extremeDihedrals(const std::array<Vector3, 4>& p, double sixVolume)
{
  ScaledAngle smallest = angleAt(p, 0);
  ScaledAngle largest = smallest;
  for (int edge = 1; edge < 6; ++edge)
  {
    const ScaledAngle angle = angleAt(p, edge);
    smallest = angle.cotangent() > smallest.cotangent() ? angle : smallest;
    largest = angle.cotangent() < largest.cotangent() ? angle : largest;
  }
  return { smallest.degrees(sixVolume), largest.degrees(sixVolume) };
}

double largestDoubleArea(const std::array<Vector3, 4>& p)
{
  const double first = std::max(norm(cross(p[1] - p[0], p[2] - p[0])), norm(cross(p[1] - p[0], p[3] - p[0])));
  const double second =
    std::max(norm(cross(p[2] - p[0], p[3] - p[0])), norm(cross(p[2] - p[1], p[3] - p[1])));
  return std::max(first, second);
}

// The largest cosine between any two of these vectors, as its square with its sign.
double largestCosineSquared(const std::array<Vector3, 4>& normal)
{
  std::array<double, 4> square;
  for (int i = 0; i < 4; ++i)
  {
    square[i] = dot(normal[i], normal[i]);
  }
  double largest = -1;
  for (const auto& faces : EdgeCorners)
  {
    const double cosine = dot(normal[faces[0]], normal[faces[1]]);
    largest = std::max(largest, cosine * std::fabs(cosine) / (square[faces[0]] * square[faces[1]]));
  }
  return largest;
}
} // namespace

std::array<double, 6> dihedralAngles(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  const std::array<Vector3, 4> p = { a, b, c, d };
  const double sixVolume = std::fabs(sixVolumes(a, b, c, d));
  std::array<double, 6> angles;
  for (int edge = 0; edge < 6; ++edge)
  {
    angles[edge] = angleAt(p, edge).degrees(sixVolume);
  }
  return angles;
}

double largestDihedral(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  return extremeDihedrals({ a, b, c, d }, std::fabs(sixVolumes(a, b, c, d))).largest;
}

double TetrahedronMeasures::stretching() const
{
  return std::min(longestEdge / std::max(smallestHeight, std::numeric_limits<double>::min()),
    std::numeric_limits<double>::max());
}

TetrahedronMeasures measure(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  const std::array<Vector3, 4> p = { a, b, c, d };
  const double sixVolume = sixVolumes(a, b, c, d);
  TetrahedronMeasures m;
  m.volume = sixVolume / 6;
  m.quality = quality(a, b, c, d);
  double longest = 0;
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& corners : EdgeCorners)
  {
    const Vector3 e = p[corners[1]] - p[corners[0]];
    longest = std::max(longest, dot(e, e));
    shortest = std::min(shortest, dot(e, e));
  }
  m.longestEdge = std::sqrt(longest);
  m.shortestEdge = std::sqrt(shortest);
  const double area = largestDoubleArea(p);
  m.smallestHeight = area > 0 ? std::fabs(sixVolume) / area : 0;
  const AngleRange angles = extremeDihedrals(p, std::fabs(sixVolume));
  m.smallestDihedral = angles.smallest;
  m.largestDihedral = angles.largest;
  return m;
}

// Swaps ask for nothing else, and spend half of their time here: most are decided by the squares of what is compared.
double angleQuality(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d, const ShapeRange& range)
{
  const Vector3 u = b - a;
  const Vector3 v = c - a;
  const Vector3 w = d - a;
  const Vector3 ofB = cross(w, v);
  const Vector3 ofC = cross(u, w);
  const Vector3 ofD = cross(v, u);
  const double sixVolume = -dot(ofD, w);
  const double squares =
    3 * (dot(u, u) + dot(v, v) + dot(w, w)) - 2 * (dot(u, v) + dot(u, w) + dot(v, w)); // of the six edges
  const double cube = squares * squares * squares;
  double squareOfPlain = 432 * sixVolume * sixVolume; // times the cube
  constexpr double certain = 1e-24;
  if (!(sixVolume > 0 && squareOfPlain > certain * cube))
  {
    // All but flat: the sign takes exact arithmetic.
    const double plain = quality(a, b, c, d);
    if (!(plain > 0))
    {
      return plain;
    }
    squareOfPlain = plain * plain * cube;
  }
  const double floor = std::max(range.floor, 0.0);
  if (!(16 * squareOfPlain > floor * floor * cube))
  {
    return floor;
  }
  // One plus the cosine of a tetrahedron's largest angle is at least the square of its quality: of all with such an
  // angle t, the best is the symmetric one, of quality root of two sin t / (1 + sin^2 t/2).
  if (squareOfPlain > range.ceiling * cube)
  {
    return std::numeric_limits<double>::infinity();
  }
  // By the normals: two faces make the angle between one normal and the other reversed. No arc tangents. The normals
  // of a closed surface add up to nothing.
  const double alike = largestCosineSquared({ Vector3{} - (ofB + ofC + ofD), ofB, ofC, ofD });
  return std::min(4 * std::sqrt(squareOfPlain / cube), 1 - std::copysign(std::sqrt(std::fabs(alike)), alike));
}
} // namespace ransmesh

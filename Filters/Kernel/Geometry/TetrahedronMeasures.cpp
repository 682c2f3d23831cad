#include "Geometry/TetrahedronMeasures.h"

#include <limits>

namespace ransmesh
{
namespace
{
constexpr double degrees = 57.29577951308232;

// The corners that are not on the edge.
constexpr int OppositeCorners[6][2] = {{2, 3}, {1, 3}, {1, 2}, {0, 3}, {0, 2}, {0, 1}};

// The faces' normals at an edge e have the vector product e * (six volumes): so the sine needs no
// difference of nearly parallel normals, and all six angles share one volume.
double dihedralAt(const std::array<Vector3, 4>& p, int edge, double sixVolume)
{
  const Vector3& from = p[EdgeCorners[edge][0]];
  const Vector3 e = p[EdgeCorners[edge][1]] - from;
  const Vector3 one = cross(e, p[OppositeCorners[edge][0]] - from);
  const Vector3 other = cross(e, p[OppositeCorners[edge][1]] - from);
  return degrees * std::atan2(norm(e) * sixVolume, dot(one, other));
}

std::array<double, 6> allDihedrals(const std::array<Vector3, 4>& p, double sixVolume)
{
  std::array<double, 6> angles;
  for (int edge = 0; edge < 6; ++edge)
  {
    angles[edge] = dihedralAt(p, edge, sixVolume);
  }
  return angles;
}

double largestDoubleArea(const std::array<Vector3, 4>& p)
{
  const double first = std::max(norm(cross(p[1] - p[0], p[2] - p[0])), norm(cross(p[1] - p[0], p[3] - p[0])));
  const double second =
    std::max(norm(cross(p[2] - p[0], p[3] - p[0])), norm(cross(p[2] - p[1], p[3] - p[1])));
  return std::max(first, second);
}
} // namespace

std::array<double, 6> dihedralAngles(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  return allDihedrals({a, b, c, d}, std::fabs(sixVolumes(a, b, c, d)));
}

double largestDihedral(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  const auto angles = dihedralAngles(a, b, c, d);
  return *std::max_element(angles.begin(), angles.end());
}

double TetrahedronMeasures::stretching() const
{
  return std::min(longestEdge / std::max(smallestHeight, std::numeric_limits<double>::min()),
    std::numeric_limits<double>::max());
}

TetrahedronMeasures measure(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  const std::array<Vector3, 4> p = {a, b, c, d};
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
  const auto angles = allDihedrals(p, std::fabs(sixVolume));
  const auto [low, high] = std::minmax_element(angles.begin(), angles.end());
  m.smallestDihedral = *low;
  m.largestDihedral = *high;
  return m;
}
} // namespace ransmesh

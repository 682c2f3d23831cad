// A triangulated surface with a patch number on each triangle: what bounds a domain before it is meshed.
#pragma once

#include "Mesh/MeshData.h"

#include <algorithm>
#include <array>
#include <vector>

namespace ransmesh
{
struct SurfaceMesh
{
  std::vector<Vector3> points;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<int> patch; // patch number (>= 1) of each triangle
};

// Smallest and largest coordinates of the points.
struct Extent
{
  Vector3 low;
  Vector3 high;

  double length(int axis) const { return high[axis] - low[axis]; }
  int longestAxis() const
  {
    const int other = length(1) > length(2) ? 1 : 2;
    return length(0) >= length(other) ? 0 : other;
  }
  // The square of a point's distance from this box; 0 within.
  double squareTo(const Vector3& p) const
  {
    const Vector3 off{ std::max(std::max(low.x - p.x, p.x - high.x), 0.0),
      std::max(std::max(low.y - p.y, p.y - high.y), 0.0),
      std::max(std::max(low.z - p.z, p.z - high.z), 0.0) };
    return dot(off, off);
  }
  void add(const Vector3& p)
  {
    low = { std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z) };
    high = { std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z) };
  }
  double largestLength() const { return std::fmax(length(0), std::fmax(length(1), length(2))); }
};

inline Extent extentOf(const std::vector<Vector3>& points)
{
  Extent extent;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      extent.low[k] = i == 0 ? points[i][k] : std::fmin(extent.low[k], points[i][k]);
      extent.high[k] = i == 0 ? points[i][k] : std::fmax(extent.high[k], points[i][k]);
    }
  }
  return extent;
}

inline Vector3 centreOf(const SurfaceMesh& surface, Index triangle)
{
  const auto& v = surface.triangles[triangle];
  return (1.0 / 3) * (surface.points[v[0]] + surface.points[v[1]] + surface.points[v[2]]);
}
} // namespace ransmesh

// The box around points, its sides along the axes.
#pragma once

#include "Geometry/Vector3.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ransmesh
{
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
  bool meets(const Extent& other) const
  {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y &&
      low.z <= other.high.z && other.low.z <= high.z;
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
} // namespace ransmesh

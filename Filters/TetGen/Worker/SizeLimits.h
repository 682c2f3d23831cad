// The edge length that the user allows at a place.
#pragma once

#include "Geometry/Vector3.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace ransmesh
{
// From x to the nearest point of the box; 0 inside.
inline double distanceToBox(const Vector3& low, const Vector3& high, const Vector3& x)
{
  Vector3 d;
  for (int k = 0; k < 3; ++k)
  {
    d[k] = std::max({ low[k] - x[k], 0.0, x[k] - high[k] });
  }
  return norm(d);
}

struct SizeBox
{
  Vector3 low;
  Vector3 high;
  double size = 0;
};

struct SizeSphere
{
  Vector3 centre;
  double radius = 0;
  double size = 0;
};

// All that lies within the radius of a segment.
struct SizeLine
{
  Vector3 from;
  Vector3 to;
  double radius = 0;
  double size = 0;
};

inline double distanceToSegment(const Vector3& a, const Vector3& b, const Vector3& x)
{
  const double square = dot(b - a, b - a);
  const double part = square > 0 ? std::clamp(dot(x - a, b - a) / square, 0.0, 1.0) : 0;
  return distance(x, a + part * (b - a));
}

// The smallest of a constant and, over boxes, spheres and lines, size + slope * distance; infinity if there
// is none.
struct SizeLimits
{
  double maximum = 0; // 0: none
  double slope = 0;
  std::vector<SizeBox> boxes;
  std::vector<SizeSphere> spheres;
  std::vector<SizeLine> lines;

  double at(const Vector3& x) const
  {
    double wanted = maximum > 0 ? maximum : std::numeric_limits<double>::infinity();
    for (const SizeBox& box : boxes)
    {
      wanted = std::min(wanted, box.size + slope * distanceToBox(box.low, box.high, x));
    }
    for (const SizeSphere& sphere : spheres)
    {
      wanted =
        std::min(wanted, sphere.size + slope * std::max(0.0, distance(x, sphere.centre) - sphere.radius));
    }
    for (const SizeLine& line : lines)
    {
      const double off = distanceToSegment(line.from, line.to, x) - line.radius;
      wanted = std::min(wanted, line.size + slope * std::max(0.0, off));
    }
    return wanted;
  }
};
} // namespace ransmesh

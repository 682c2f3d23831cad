// The edge length that follows from the sizes at given points.
#pragma once

#include "Geometry/Vector3.h"

#include <cstdint>
#include <vector>

namespace ransmesh
{
struct SizePoint
{
  Vector3 place;
  double size = 0;
};

// min over all points of size + slope * distance, by a tree of boxes.
class PointSizes
{
public:
  PointSizes(std::vector<SizePoint> points, double slope);
  // Infinity without points.
  double at(const Vector3& x) const;

private:
  struct Node
  {
    Vector3 low;
    Vector3 high;
    double smallest = 0;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint32_t right = 0; // the second child; the first follows its parent; 0 for a leaf
  };

  std::uint32_t build(std::uint32_t begin, std::uint32_t end);
  double bound(const Node& node, const Vector3& x) const;
  void search(std::uint32_t node, const Vector3& x, double& best) const;

  std::vector<SizePoint> points_;
  std::vector<Node> nodes_;
  double slope_;
};
} // namespace ransmesh

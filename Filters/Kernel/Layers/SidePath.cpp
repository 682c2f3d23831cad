#include "Layers/SidePath.h"

#include <algorithm>

namespace ransmesh
{
std::size_t SidePath::segmentAt(double height, double& part) const
{
  const auto above = std::upper_bound(
    nodes.begin() + 1, nodes.end() - 1, height, [](double h, const Node& node) { return h < node.height; });
  const Node& low = *(above - 1);
  part = std::clamp((height - low.height) / (above->height - low.height), 0.0, 1.0);
  return static_cast<std::size_t>(above - nodes.begin()) - 1;
}

Vector3 SidePath::at(double height) const
{
  double part = 0;
  const std::size_t i = segmentAt(height, part);
  return nodes[i].point + part * (nodes[i + 1].point - nodes[i].point);
}

std::array<Vector3, 2> SidePath::normalsAt(double height) const
{
  double part = 0;
  const std::size_t i = segmentAt(height, part);
  std::array<Vector3, 2> normal;
  for (int side = 0; side < 2; ++side)
  {
    const Vector3& low = nodes[i].normal[side];
    normal[side] = normalized(low + part * (nodes[i + 1].normal[side] - low));
  }
  return normal;
}
} // namespace ransmesh

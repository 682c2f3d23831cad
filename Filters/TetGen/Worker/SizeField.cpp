#include "SizeField.h"

#include "SizeLimits.h"

#include <algorithm>
#include <limits>

namespace ransmesh
{
PointSizes::PointSizes(std::vector<SizePoint> points, double slope)
  : points_(std::move(points))
  , slope_(slope)
{
  if (!points_.empty())
  {
    build(0, static_cast<std::uint32_t>(points_.size()));
  }
}

std::uint32_t PointSizes::build(std::uint32_t begin, std::uint32_t end)
{
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  Node node{ points_[begin].place, points_[begin].place, points_[begin].size, begin, end, 0 };
  for (std::uint32_t i = begin; i < end; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      node.low[k] = std::min(node.low[k], points_[i].place[k]);
      node.high[k] = std::max(node.high[k], points_[i].place[k]);
    }
    node.smallest = std::min(node.smallest, points_[i].size);
  }
  nodes_.push_back(node);
  constexpr std::uint32_t leafSize = 8;
  if (end - begin > leafSize)
  {
    const Vector3 extent = node.high - node.low;
    const int axis = extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(points_.begin() + begin, points_.begin() + middle, points_.begin() + end,
      [axis](const SizePoint& a, const SizePoint& b) { return a.place[axis] < b.place[axis]; });
    build(begin, middle);
    nodes_[number].right = build(middle, end);
  }
  return number;
}

double PointSizes::bound(const Node& node, const Vector3& x) const
{
  return node.smallest + slope_ * distanceToBox(node.low, node.high, x);
}

void PointSizes::search(std::uint32_t number, const Vector3& x, double& best) const
{
  const Node& node = nodes_[number];
  if (node.right == 0)
  {
    for (std::uint32_t i = node.begin; i < node.end; ++i)
    {
      best = std::min(best, points_[i].size + slope_ * distance(points_[i].place, x));
    }
    return;
  }
  std::uint32_t near = number + 1;
  std::uint32_t far = node.right;
  double nearBound = bound(nodes_[near], x);
  double farBound = bound(nodes_[far], x);
  if (farBound < nearBound)
  {
    std::swap(near, far);
    std::swap(nearBound, farBound);
  }
  if (nearBound < best)
  {
    search(near, x, best);
  }
  if (farBound < best)
  {
    search(far, x, best);
  }
}

double PointSizes::at(const Vector3& x) const
{
  double best = std::numeric_limits<double>::infinity();
  if (!nodes_.empty())
  {
    search(0, x, best);
  }
  return best;
}
} // namespace ransmesh

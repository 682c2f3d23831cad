// The way of a column that stays in curved adjoining patches: a polyline on their own triangles.
#pragma once

#include "Geometry/Vector3.h"

#include <array>
#include <vector>

namespace ransmesh
{
struct SidePath
{
  struct Node
  {
    double height = 0; // above the wall
    Vector3 point;
    std::array<Vector3, 2> normal; // of the two sides there, unit, into the fluid; zero for no side
  };

  Vector3 up;              // the height of x is dot(x - base, up)
  std::vector<Node> nodes; // heights rise; the first is the base

  bool isEmpty() const { return nodes.empty(); }
  // The height at which the path ends.
  double top() const { return nodes.back().height; }
  double heightOf(const Vector3& x) const { return dot(x - nodes.front().point, up); }
  // The point at a height, not above top().
  Vector3 at(double height) const;
  // The normals of the two sides at a height.
  std::array<Vector3, 2> normalsAt(double height) const;

private:
  // The node below the height, and how far it is from there to the next one, 0 to 1.
  std::size_t segmentAt(double height, double& part) const;
};
} // namespace ransmesh

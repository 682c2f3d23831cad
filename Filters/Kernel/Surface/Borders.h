// The borders of an open surface.
#pragma once

#include "Triangles/SurfaceMesh.h"

namespace ransmesh
{
// A chain of open edges, so that the surface's triangles lie on its left, seen from where they face.
struct BorderLoop
{
  std::vector<Index> points; // in order; of a closed loop the first is not repeated
  bool isClosed = false;
  Extent extent;
};

// Points of equal coordinates must be one point, and triangles be oriented alike. Each open edge is in one loop; a
// loop that touches itself at a point is parted there.
std::vector<BorderLoop> findBorders(const SurfaceMesh& surface);

// A flag a point: whether it lies on an open edge.
std::vector<char> borderPoints(const SurfaceMesh& surface);
} // namespace ransmesh

// Gaps between the rims of parts that should hang together, also where the rims have different points.
#pragma once

#include "Surface/Welding.h"

namespace ransmesh
{
struct StitchReport
{
  std::size_t points = 0; // that entered open edges
  double farthest = 0;    // how far one of these edges moved
  Vector3 where;          // the first
};

// Puts points of the border that lie within the tolerance (in the surface's unit) of an open edge, between its ends,
// into that edge: its triangle is divided. So the rims of a gap with unequal points come to share their points,
// once equal points have been welded (Welding.h), and points that merely lie on a neighbour's edge become part of it.
// What is farther than a third of the edge, or than half of its triangle's height, stays apart.
StitchReport stitchBorders(SurfaceMesh& surface, double tolerance);

struct GapReport
{
  WeldReport weld;
  StitchReport stitch;
};

// Welds borders, and stitches them, too, where that closes more of them. Nothing is done where no open edge is closed.
GapReport closeGaps(SurfaceMesh& surface, double tolerance);

// The smallest tolerance by which closeGaps closes the surface, as far as can be told: the largest distance of a
// point of the border to the nearest other open edge, where this is less than a third of that edge. 0 if there is none.
double widthOfUnequalGaps(const SurfaceMesh& surface);
} // namespace ransmesh

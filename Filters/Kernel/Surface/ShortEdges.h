// Edges of a surface that are too short to be meant.
#pragma once

#include "Triangles/SurfaceMesh.h"

namespace ransmesh
{
struct CollapseReport
{
  std::size_t edges = 0;
  Vector3 where; // the first
};

// Draws the ends of edges shorter than `shortest` (in the surface's unit) together into one of them. An edge stays
// where that would change how the surface hangs together, turn a triangle over, or move the border of a patch.
// Points of equal coordinates must be one point.
CollapseReport collapseShortEdges(SurfaceMesh& surface, double shortest);
} // namespace ransmesh

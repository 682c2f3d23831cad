// Borders of a surface that should coincide.
#pragma once

#include "Triangles/SurfaceMesh.h"

namespace ransmesh
{
struct WeldReport
{
  std::size_t points = 0; // that became another one
  double farthest = 0;    // how far the farthest of them moved
  Vector3 where;          // the first
};

// Makes points on open edges that lie within the tolerance (in the surface's unit) of each other one point, the
// nearest first. Two points of one triangle stay apart, and those that are not nearer than half of the open
// edges there.
WeldReport weldBorders(SurfaceMesh& surface, double tolerance);

// The smallest tolerance by which weldBorders closes the surface, as far as can be told: the largest distance of a
// point of the border to the nearest other one, where this is less than a third of the open edges there. 0 if
// there is none.
double widthOfGaps(const SurfaceMesh& surface);
} // namespace ransmesh

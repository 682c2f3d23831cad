// The lengths of a surface's edges: as they are, and as they should be.
#pragma once

#include "Triangles/SurfaceMesh.h"

#include <functional>
#include <vector>

namespace ransmesh
{
// The mean length of the edges at each point, limited so that along an edge it grows by at most
// `slope` times the edge's length.
std::vector<double> sizesOnSurface(const SurfaceMesh& surface, double slope);

// Halves edges longer than `factor` times limit(midpoint), again and again, so that the surface stays
// closed; the longest edge of a triangle goes first, which keeps the angles good. New points lie on the
// old triangles; patches are kept. `limit` must be positive; infinity leaves an edge alone.
// False, with the surface in between, where that takes more than `mostTriangles`.
bool halveLongEdges(SurfaceMesh& surface, const std::function<double(const Vector3&)>& limit,
  std::size_t mostTriangles = 20'000'000, double factor = 1.5);

// The volume that a closed surface encloses, in the cube of the length unit: rounded, and too small
// where triangles are not turned alike. The second closes an open surface by triangles to the apex.
double enclosedVolume(const SurfaceMesh& surface);
double enclosedVolume(const SurfaceMesh& surface, const Vector3& apex);
} // namespace ransmesh

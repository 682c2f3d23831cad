// Where a triangulated surface cuts or touches itself.
#pragma once

#include "Triangles/SurfaceMesh.h"

#include <utility>
#include <vector>

namespace ransmesh
{
// The pairs of triangles that meet elsewhere than in the points and edges that they share by number,
// decided exactly; sorted. Triangles with the same three points are not reported. The triangles must
// not be degenerate. At most `limit` pairs are given.
std::vector<std::pair<Index, Index>> findIntersections(const SurfaceMesh& surface, std::size_t limit = 10000);
} // namespace ransmesh

// Where sheets of a triangulated surface nearly touch.
#pragma once

#include "Triangles/SurfaceMesh.h"

#include <utility>
#include <vector>

namespace ransmesh
{
// The pairs of triangles without a common point that come nearer to each other than `distance`, measured from
// corners to triangles, and than a tenth of their own shortest edges; sorted. At most `limit` pairs are given.
std::vector<std::pair<Index, Index>> findNearTriangles(
  const SurfaceMesh& surface, double distance, std::size_t limit);
} // namespace ransmesh

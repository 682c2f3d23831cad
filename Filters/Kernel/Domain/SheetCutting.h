// Cuts sheets off where they reach out of a box.
#pragma once

#include "Triangles/SurfaceMesh.h"

#include <cstddef>

namespace ransmesh
{
// What reaches out of the box goes; the new border lies exactly in the box's sides. Points within tolerance of a
// side are put on it; so are those that are near to it for the length of an edge that passes through it, along
// that edge, so that no triangle becomes much thinner. Points that are not used any more remain. Gives the
// number of triangles that reached out.
std::size_t cutByBox(SurfaceMesh& sheets, const Extent& box, double tolerance);
} // namespace ransmesh

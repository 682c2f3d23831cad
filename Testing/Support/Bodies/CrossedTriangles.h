// Which triangles of a surface cross others: by comparing all pairs, in plain words, to check a cleverer search by.
#pragma once

#include "Triangles/SurfaceMesh.h"

#include <set>

namespace bodies
{
// Two triangles cross where an edge of one passes through the inside of the other, or where they overlap in one
// plane. Those that only touch, or meet in a common point or edge, do not. For surfaces of some hundred triangles
// whose coordinates are about 1 and not within 1e-9 of touching.
std::set<ransmesh::Index> crossedTriangles(const ransmesh::SurfaceMesh& surface);
} // namespace bodies

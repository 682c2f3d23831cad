// The peer: CGAL's Delaunay triangulation of the same points.
#pragma once

#include "Geometry/Vector3.h"

#include <cstddef>
#include <vector>

namespace ransmesh_benchmarks
{
// Inserts the points, spatially sorted, with the exact-predicates kernel; gives the number of
// tetrahedra.
std::size_t insertByCgal(const std::vector<ransmesh::Vector3>& points);
} // namespace ransmesh_benchmarks

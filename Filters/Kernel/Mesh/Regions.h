// The parts of a mesh that hang together.
#pragma once

#include "Mesh/MeshData.h"

#include <vector>

namespace ransmesh
{
// The number of each tetrahedron's region, from 1, in the order of their first tetrahedra. Regions are divided by
// triangles: one that sheets do not close off goes on behind them.
std::vector<int> numberRegions(const MeshData& mesh);
} // namespace ransmesh

// Tetrahedra of which double precision does not tell which way they are turned.
#pragma once

#include "Mesh/MeshData.h"
#include "Support/Patch.h"

#include <cstddef>

namespace ransmesh
{
// How many there are: of a quality (Geometry/TetrahedronMeasures.h) whose sign rounding may turn. They are valid in
// exact arithmetic, but programs that compute in doubles may take them for inverted.
std::size_t countFlatTetrahedra(const MeshData& mesh);

// Swaps them away where that is possible; no point moves, and the boundary stays as it is. The mesh must be valid and
// without sheets. Gives the number that is left.
std::size_t swapFlatTetrahedra(const PatchTable& patches, MeshData& mesh);
} // namespace ransmesh

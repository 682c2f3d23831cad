// Makes the two sides of a sheet alike again, after new points came on both of them.
#pragma once

#include "Mesh/MeshData.h"

#include <vector>

namespace ransmesh
{
// Where walls meet, enrichment divides the triangles next to the ridge; on the two sides of a sheet in the same
// way, but the new points differ: by rounding, or by as much as the other wall's slope does from the one side
// to the other. Moves those of the second side onto those of the first. Triangles are paired by topology, from
// those outward whose points are equal. False, and nothing is moved, where the two sides are not divided
// alike, or a tetrahedron would not stay positive, exactly. The mesh must be cut open along its sheets.
bool fitSheets(MeshData& mesh, const std::vector<int>& sheetPatches);
} // namespace ransmesh

// Where the front, as it is planned, would get in its own way.
//
// Columns are limited by the gap to the opposite wall, but what single points see is not all: beside concave edges,
// between needles and at the ends of fans the triangles that the tops are to span may pass through each other, or
// through a bare wall. No connectivity helps there: one top would be left far behind its neighbours.
#pragma once

#include "Layers/Column.h"
#include "Mesh/TetMesh.h"

#include <cstddef>

namespace ransmesh
{
// Lowers the columns at triangles of the planned front that pass through others, on both sides to one height, a little
// below that at which they would touch; and those around them, so that heights do not differ by more than the usual
// slope. Columns at triangles that only touch, or cannot be lowered, stay. Gives the number of columns lowered.
std::size_t limitByCrossings(const TetMesh& mesh, ColumnSet& set);
} // namespace ransmesh

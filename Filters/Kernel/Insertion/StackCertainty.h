// A quick proof that a stack of layers does not fold.
#pragma once

#include "Insertion/BaseFaces.h"
#include "Layers/Column.h"
#include "Mesh/TetMesh.h"

namespace ransmesh
{
// True only if every tetrahedron of the face's stack is positive in exact arithmetic, with all points where
// their columns say (ColumnSet::pointAt); false says nothing.
//
// With straight columns b + h d, the tetrahedron by which corner j rises by s has s N.d_j as its six volumes,
// where N is the normal of the triangle of the current corners. N.d_j does not depend on j's own height and is
// linear in each of the other two: so it is smallest where both are at an end of their columns, and four
// values for each corner take the place of all levels. A margin covers the rounding of the coordinates. On a
// ship's hull this is five times quicker than asking each tetrahedron.
bool isSurelyPositive(const TetMesh& mesh, const ColumnSet& set, const BaseFace& face);
} // namespace ransmesh

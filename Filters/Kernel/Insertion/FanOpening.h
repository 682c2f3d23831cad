// Opens the fans before the front rises: each column gets a top of its own.
//
// The root's ball is split by the star operator, one column after the other: a new vertex, a little way
// out along the column, takes over the wall's faces that the column lifts. Between it and the root come
// faces of the front that have no triangle of the wall below them: two of their corners, or all three,
// stand on the same root. They have the patch FrontOnly (FanFaces.h).
#pragma once

#include "Layers/Column.h"
#include "Mesh/TetMesh.h"

#include <cstddef>

namespace ransmesh
{
struct FanReport
{
  std::size_t planned = 0; // columns beside the main ones
  std::size_t opened = 0;
};

// Opens all fans of columns that have layers, as far as the mesh allows; what could not be split off falls
// to its neighbour in the fan.
FanReport openFans(TetMesh& mesh, ColumnSet& set);
} // namespace ransmesh

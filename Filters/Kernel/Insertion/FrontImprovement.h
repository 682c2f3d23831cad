// Better tetrahedra beyond the front, once it has risen.
#pragma once

#include "Improvement/LocalImprovement.h"
#include "Layers/Column.h"
#include "Mesh/TetMesh.h"
#include "Support/Context.h"

#include <cstddef>

namespace ransmesh
{
// Swaps and moves points where tetrahedra at the tops of the columns are poor, and where that made new
// ones. The front and all boundaries stay as they are. Gives the number of changes.
std::size_t improveBeyondFront(
  TetMesh& mesh, const ColumnSet& set, const BoundaryRules& rules, const Context& context);
} // namespace ransmesh

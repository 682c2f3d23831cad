// Raising the front to the layers' thickness.
#pragma once

#include "Boundary/Classification.h"
#include "Insertion/FrontMoves.h"
#include "Layers/Column.h"
#include "Mesh/TetMesh.h"
#include "Support/Context.h"

#include <array>
#include <cstddef>

namespace ransmesh
{
struct RaisingReport
{
  std::size_t movedTogether = 0; // steps of tops that needed no look at connectivity
  std::array<std::size_t, static_cast<std::size_t>(MoveVerdict::Count)> verdicts{}; // of single moves
  std::size_t stuck = 0; // tops that stopped below their column's height
};

// Moves every top out along its column, in sweeps of a part of the surface size: first all together,
// then, where that would spoil the mesh beyond, one by one with changes of connectivity. The mesh is
// valid at every moment. A top that gets stuck ends on the highest level that it reaches, and its column
// is cut there (StopReason::Refused, or Gap where the front would cross itself above). Afterwards the wall's vertices are the tops of their columns.
// No triangle of a curved side turns away from the side's surface by more than maximumSurfaceAngle
// (degrees). False if cancelled; the mesh is then of no use.
bool raiseFront(TetMesh& mesh, ColumnSet& set, const Classification& classes, double maximumSurfaceAngle,
  const Context& context, RaisingReport& report);
} // namespace ransmesh

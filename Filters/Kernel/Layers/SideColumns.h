// Columns that stand in adjoining patches follow these patches' own surfaces.
#pragma once

#include "Boundary/BoundaryStars.h"
#include "Layers/Column.h"

namespace ransmesh
{
// Gives every column that stays in a curved side, or in the curved ridge of two sides, its path on the
// sides' triangles; columns in planes stay straight. A column ends where its side bends away from it
// (StopReason::CurvedSide), and at gapFraction of the way to the side's border, which is where an
// opposite surface begins (StopReason::Gap).
void followSides(
  const TetMesh& mesh, const BoundaryStars& stars, const LayerPlan& plan, double gapFraction, ColumnSet& set);
} // namespace ransmesh

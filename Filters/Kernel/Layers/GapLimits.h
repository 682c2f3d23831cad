// How high the columns may grow between two surfaces.
#pragma once

#include "Boundary/BoundaryStars.h"
#include "Layers/Column.h"

namespace ransmesh
{
// No column beyond gapFraction of the distance to the surface in front of it: in its own direction, and,
// where its wall faces turn, in the direction of each of them. The distances are found by walking
// through the mesh. The same beside other walls (ClearBall.h), and over the middles of faces (FaceGaps.h).
void limitByGap(const TetMesh& mesh, const BoundaryStars& stars, double gapFraction, ColumnSet& set);
} // namespace ransmesh

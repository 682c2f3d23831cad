// Puts the mesh beyond the front and the stacks below it together.
#pragma once

#include "Insertion/BaseFaces.h"
#include "Insertion/Enrichment.h"

namespace ransmesh
{
// mesh: what lies beyond the raised front, where no stack folds. Fills everything in result but the
// report's counts of the stages before.
void writeEnriched(
  const TetMesh& mesh, const ColumnSet& set, double maximumSurfaceAngle, EnrichedMesh& result);
} // namespace ransmesh

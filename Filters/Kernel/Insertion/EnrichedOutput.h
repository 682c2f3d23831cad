// Puts the mesh beyond the front and the stacks below it together.
#pragma once

#include "Insertion/BaseFaces.h"
#include "Insertion/Enrichment.h"

namespace ransmesh
{
// mesh: what lies beyond the raised front; faces: its base faces, sides found. Fills everything in result
// but the report's raising part. Gives the base faces whose stacks have a tetrahedron that is not
// positive; if there are any, result is no mesh.
std::vector<Index> writeEnriched(
  const TetMesh& mesh, const ColumnSet& set, const std::vector<BaseFace>& faces, EnrichedMesh& result);
} // namespace ransmesh

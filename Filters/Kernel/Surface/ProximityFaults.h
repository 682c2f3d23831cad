// Where parts of a surface cross, or come too near to each other.
#pragma once

#include "Surface/Diagnosis.h"

namespace ransmesh
{
// Points of equal coordinates must be one point, and no triangle be degenerate. A fault has count 0 where there
// is none.

// Pairs of triangles that meet elsewhere than in common points and edges, decided exactly.
Fault findCrossings(const SurfaceMesh& surface);

// About where two triangles meet: where a side of one passes through the other.
Vector3 meetingPlace(const SurfaceMesh& surface, Index s, Index t);

// Pairs of triangles without a common point that come nearer to each other than `distance`, measured from
// corners to triangles, and than a tenth of their own shortest edges. Not the pairs in `crossing` (sorted).
Fault findNearSheets(
  const SurfaceMesh& surface, double distance, const std::vector<std::pair<Index, Index>>& crossing);
} // namespace ransmesh

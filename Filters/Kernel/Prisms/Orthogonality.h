// Moves points beyond the layers, where cell-centred solvers would meet faces that lie askew.
//
// The non-orthogonality of a face is the angle between its normal and the line from one cell's centre to the
// other's. Solvers warn above 70 degrees.
#pragma once

#include "Mesh/FaceMatching.h"

#include <vector>

namespace ransmesh
{
struct OrthogonalityReport
{
  std::size_t movedPoints = 0;
  std::size_t facesOver = 0; // above the limit, in the end
  double largest = 0;        // degrees, in the end, of faces with a tetrahedron that is in no prism
};

// Moves points of which all tetrahedra are in no prism, and that are on no boundary and no sheet, one at a time,
// until no face of those tetrahedra exceeds the limit (degrees), or nothing helps. Every tetrahedron stays
// positive in exact arithmetic, and of a fair shape. prism: as for recombinePrisms; the tetrahedra of one number
// count as one cell.
OrthogonalityReport improveOrthogonality(
  MeshData& mesh, const FaceMatching& matching, const std::vector<Index>& prism, double limit);
} // namespace ransmesh

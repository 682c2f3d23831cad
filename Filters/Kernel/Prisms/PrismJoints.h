// Prisms that go together, where the layers of two walls meet in a concave corner, or fans stand on a convex ridge.
#pragma once

#include "Mesh/FaceMatching.h"

#include <vector>

namespace ransmesh
{
// prism: of each tetrahedron, those of one prism share a number; negative for none. Gives the same with fewer numbers:
// - one and two tetrahedra that are halves of a prism lying along the corner become one;
// - two prisms become one, six tetrahedra that are to be a hexahedron, where two triangles of them make a
//   quadrilateral of a third: that of a prism lying along a corner or below a fan, or of such a pair. So pairs
//   grow from level to level.
// What has more than three tetrahedra in the first place is no prism: its tetrahedra get no number.
std::vector<Index> joinPrisms(
  const MeshData& mesh, const FaceMatching& matching, const std::vector<Index>& prism);
} // namespace ransmesh

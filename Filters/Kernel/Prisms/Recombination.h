// Wedges from the tetrahedra of each prism, hexahedra from those of two that go together (Prisms/PrismJoints.h), with
// pyramids and tetrahedra where they end, so that the mesh stays conforming: quadrilaterals meet quadrilaterals only.
#pragma once

#include "Mesh/MixedMesh.h"
#include "Prisms/Orthogonality.h"
#include "Support/Context.h"
#include "Support/Outcome.h"

#include <vector>

namespace ransmesh
{
struct RecombinationReport
{
  std::size_t prismTets = 0;    // that the mesh had in prisms
  std::size_t tetsInWedges = 0; // of these, that became wedges and hexahedra
  std::size_t newPoints = 0;    // amid prisms that have quadrilaterals on some sides and triangles on others

  OrthogonalityReport orthogonality;

  // Of the layers' tetrahedra, 0 to 1; 1 where there are none.
  double shareInWedges() const
  {
    return prismTets == 0 ? 1 : static_cast<double>(tetsInWedges) / static_cast<double>(prismTets);
  }
};

struct RecombinedMesh
{
  MixedMesh mesh; // the points of the given mesh, some of them moved, then the new ones
  // Where things come from: a tetrahedron of each cell, a triangle of each boundary polygon, a point beside each
  // new point.
  std::vector<Index> cellOrigin;
  std::vector<Index> boundaryOrigin;
  std::vector<Index> newPointOrigin;
  RecombinationReport report;
};

// given: a valid mesh. prism: of each tetrahedron, those of one prism share a number; negative for none. Two or three
// tetrahedra of a number are a prism or a part of one; where they are not, they stay. BadInput for a mesh whose
// faces do not match; Cancelled.
// maximumNonOrthogonality: what improveOrthogonality (Prisms/Orthogonality.h) is to reach; 90 moves nothing.
Outcome recombinePrisms(const MeshData& given, const std::vector<Index>& prism,
  double maximumNonOrthogonality, const Context& context, RecombinedMesh& result);
} // namespace ransmesh

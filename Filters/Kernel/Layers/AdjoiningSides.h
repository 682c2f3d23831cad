// Which of the patches beside a wall are sides, where columns rise within the patch, at one of the wall's vertices.
#pragma once

#include "Boundary/BoundaryStars.h"

#include <vector>

namespace ransmesh
{
// Faces of one adjoining patch without a ridge between them, seen as a plane.
struct Side
{
  int patch = 0;
  Vector3 normal;  // unit, into the fluid
  double rise = 0; // least cosine between the wall's normal and the way into the side
};

// Finds, among the faces at a vertex that are not the wall's, the groups that rise from the wall: from all of it there
// and from each of its faces beside them. Where a trailing edge ends on a hull, a symmetry plane rises from the hull but
// goes on nearly as the wing does. False where groups of one patch, of which only some rise, are not to be told apart
// further on.
bool findSides(const TetMesh& mesh, const std::vector<FaceAtVertex>& others,
  const std::vector<FaceAtVertex>& walls, std::vector<Side>& sides);

// Does each of the faces lie in the plane of a side of its patch?
bool arePlane(const std::vector<FaceAtVertex>& others, const std::vector<Side>& sides);

// The sides' unit normals.
std::vector<Vector3> normalsOf(const std::vector<Side>& sides);
} // namespace ransmesh

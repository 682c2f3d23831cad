// Divides what would not fall apart when a mesh is cut open along its sheets.
#pragma once

#include "Boundary/SheetSides.h"

#include <array>
#include <vector>

namespace ransmesh
{
// An edge, or, with three points, a triangle of a sheet, that gets a point in its middle.
struct SheetJoint
{
  std::array<Index, 3> vertex{ None, None, None }; // the last one None for an edge
};

// The edges with tetrahedra on two sides of a sheet both of whose ends stay one point; where there are none,
// the triangles whose three points do. No two of them share a tetrahedron: divide and ask again.
std::vector<SheetJoint> findJoints(
  const MeshData& mesh, const std::vector<SheetTriangle>& sheets, const SheetSides& sides);

// Puts a point into each joint. Gives the joint that has no place for one in exact arithmetic, or null.
const SheetJoint* divideJoints(
  MeshData& mesh, const std::vector<SheetJoint>& joints, const SheetSides& sides);
} // namespace ransmesh

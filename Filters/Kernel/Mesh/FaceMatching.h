// Who is whose neighbour in a mesh given as plain arrays.
#pragma once

#include "Mesh/MeshData.h"

#include <vector>

namespace ransmesh
{
// A triangle inside the mesh, and the face on one side of it.
struct SheetFace
{
  Index triangle = None;
  Index side = None; // 4 * tetrahedron + face
};

struct FaceMatching
{
  // Of each face 4 * tetrahedron + face: the other side's face; -(triangle + 1) where a boundary
  // triangle covers it; Unmatched where neither does.
  std::vector<Index> opposite;
  // The triangles of sheets: of patches all of whose triangles lie between two tetrahedra. In no order.
  std::vector<SheetFace> sheets;
  // Faults, each with the number of the first tetrahedron or triangle that has it.
  std::size_t facesInMoreThanTwoTets = 0;
  std::size_t facesWithoutTriangle = 0;
  std::size_t trianglesOffTheBoundary = 0;
  std::size_t repeatedTriangles = 0;
  Index firstFaultyTet = None;
  Index firstFaultyTriangle = None;

  static constexpr Index Unmatched = -2147483647;
  bool ok() const
  {
    return !facesInMoreThanTwoTets && !facesWithoutTriangle && !trianglesOffTheBoundary && !repeatedTriangles;
  }
};

// Indices must be in range. Time and memory are linear in the size of the mesh.
FaceMatching matchFaces(const MeshData& mesh);
} // namespace ransmesh

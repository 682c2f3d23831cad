// Measures of every tetrahedron of a mesh.
#pragma once

#include "Mesh/TetMesh.h"

#include <cstddef>
#include <vector>

namespace ransmesh
{
// Indexed by tetrahedron; angles in degrees, lengths in the unit of the points.
struct CellMeasures
{
  std::vector<double> volume; // signed
  std::vector<double> longestEdge;
  std::vector<double> shortestEdge;
  std::vector<double> largestDihedral;
  std::vector<double> smallestDihedral;
  std::vector<double> stretching;  // longest edge over smallest height
  std::vector<double> quality;     // volume over the cube of the rms edge, 1 for the regular tetrahedron
  std::vector<HalfFace> innerFace; // of each boundary triangle: the tetrahedron's face it lies on, or None

  std::size_t count() const { return volume.size(); }
};

// Point numbers must be in range and the points finite. Leaves innerFace empty.
CellMeasures measureCells(const MeshData& mesh);
} // namespace ransmesh

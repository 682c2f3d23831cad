// What makes a mixed mesh valid, as counted faults.
#pragma once

#include "Mesh/MixedMesh.h"

#include <string>

namespace ransmesh
{
struct MixedFaults
{
  std::size_t indicesOutOfRange = 0;
  std::size_t pointsNotFinite = 0;
  std::size_t cellsNotSound = 0; // tetrahedra not positive, others not sound (Mesh/MixedMesh.h)
  // A quadrilateral that meets two triangles counts as all three.
  std::size_t facesAlone = 0;       // of one cell, and no boundary polygon covers them
  std::size_t facesOfMoreCells = 0; // than two
  std::size_t facesTurnedAlike = 0; // of two cells that lie on the same side, or whose points run otherwise
  std::size_t polygonsOffTheBoundary =
    0; // that cover no cell's face, or, but for sheets, one between two cells
  std::size_t polygonsRepeated = 0;
  std::size_t polygonsTurnedInward = 0;
  Index firstCell = None; // that has a fault

  bool none() const;
  // All faults in one line.
  std::string text() const;
};

// Complete, but for points that coincide or are unused. Linear in the size of the mesh, but for a sort.
MixedFaults findFaults(const MixedMesh& mesh);
} // namespace ransmesh

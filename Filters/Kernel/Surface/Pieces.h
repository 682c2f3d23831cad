// The connected pieces of a surface, and which of them lies in which.
#pragma once

#include "Triangles/SurfaceMesh.h"

namespace ransmesh
{
// What hangs together by common points.
struct SurfacePiece
{
  std::size_t triangles = 0;
  std::size_t openEdges = 0;
  Extent extent;
  double area = 0;
  double volume = 0;      // that it encloses, > 0 where its triangles face outward; 0 unless it is closed
  int enclosedBy = -1;    // the smallest closed piece around it, if there is one
  std::vector<int> patch; // the patches of its triangles, ascending

  bool isClosed() const { return openEdges == 0; }
};

// Points must be finite, and those of equal coordinates be one point. In the order of their first triangles.
// Whether a piece lies in another is decided by one of its points, in rounded arithmetic: where pieces cross
// it says little.
std::vector<SurfacePiece> findPieces(const SurfaceMesh& surface);
} // namespace ransmesh

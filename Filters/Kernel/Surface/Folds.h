// Triangles that a surface has more than once.
#pragma once

#include "Triangles/SurfaceMesh.h"

namespace ransmesh
{
struct DuplicateReport
{
  std::size_t dropped = 0; // copies of triangles of which one stayed
  std::size_t folded = 0;  // triangles back to back of which none stayed
  Vector3 where;           // the first
};

// Of triangles with the same three points one stays, or none: pairs back to back that are joined to each other
// along their border, too, are a fold without thickness, which encloses nothing; it goes if it is small (its
// extent at most `largestFold`).
DuplicateReport dropDuplicates(SurfaceMesh& surface, double largestFold);
} // namespace ransmesh

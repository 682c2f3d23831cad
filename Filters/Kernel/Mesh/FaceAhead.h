// For loops over all boundary faces, which look at their tetrahedra.
#pragma once

#include "Mesh/TetMesh.h"

#include <cstddef>

namespace ransmesh
{
// At boundary face b, brings the tetrahedron of one further on into the cache.
inline void fetchAheadOfFace(const TetMesh& mesh, std::size_t b)
{
  constexpr std::size_t ahead = 16;
  if (b + ahead < mesh.boundarySlots() && mesh.boundaryFace(static_cast<Index>(b + ahead)).isAlive())
  {
    mesh.fetchAhead(tetOf(mesh.boundaryFace(static_cast<Index>(b + ahead)).inner));
  }
}
} // namespace ransmesh

// Collapse of a vertex onto a neighbour, in place: star(ball of v, u) where the outer faces are known.
//
// The tetrahedra of the ball that do not have u keep their numbers and get u instead of v; those at the
// edge (v, u) go, and what stood on both sides of them meets. A fraction of the work of Mesh/Star.h.
#pragma once

#include "Mesh/TetMesh.h"

#include <span>

namespace ransmesh
{
// May the ball of v (all its tetrahedra) be starred from its neighbour u, as far as neighbours go? Not
// if a boundary face would lose its tetrahedron. That the new tetrahedra are exactly positive, and that
// the surface stays one where v is on it, is for the caller to see to: then the mesh stays valid.
bool canCollapse(const TetMesh& mesh, std::span<const Index> ball, Index v, Index u);

// Does it. Boundary faces at v follow to u with their patches; those at the edge (v, u) go.
void collapse(TetMesh& mesh, std::span<const Index> ball, Index v, Index u);
} // namespace ransmesh

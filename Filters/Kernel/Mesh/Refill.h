// Exchange of some tetrahedra for others that fill the same place.
#pragma once

#include "Mesh/TetMesh.h"

#include <array>
#include <span>
#include <vector>

namespace ransmesh
{
// A face between a set of tetrahedra and what is around it.
struct RimFace
{
  std::array<Index, 3> vertex; // turned inward
  HalfFace beyond;             // what lies on its other side
};

// All such faces of distinct tetrahedra.
std::vector<RimFace> rimOf(const TetMesh& mesh, std::span<const Index> tets);

// Takes out the tetrahedra and puts in the fresh ones, which must be positive and have the same faces to what is
// around, each other face twice: then the mesh stays valid. Boundary faces stay with their patches; vertices that
// no fresh tetrahedron has are unused then. Gives the fresh ones' numbers.
std::vector<Index> refill(
  TetMesh& mesh, std::span<const Index> tets, std::span<const std::array<Index, 4>> fresh);
} // namespace ransmesh

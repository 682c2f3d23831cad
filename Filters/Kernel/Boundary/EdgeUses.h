// The edges of a few boundary faces, those that two faces share side by side.
#pragma once

#include "Mesh/TetMesh.h"

#include <array>
#include <span>
#include <vector>

namespace ransmesh
{
struct EdgeUse
{
  Index low;
  Index high;
  std::array<Index, 2> way; // as the face, turned inward, has it
  Index face;

  bool isSameEdge(const EdgeUse& other) const { return low == other.low && high == other.high; }
};

// Fills edges with all edges of the faces, in order of their ends, then of face.
void collectEdgeUses(const TetMesh& mesh, std::span<const Index> faces, std::vector<EdgeUse>& edges);
} // namespace ransmesh

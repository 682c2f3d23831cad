// The tetrahedra of each prism, and the quadrilaterals between one prism and the next.
#pragma once

#include "Mesh/FaceMatching.h"
#include "Mesh/TetMesh.h"

#include <array>
#include <vector>

namespace ransmesh
{
// Two triangles that two prisms, or a prism and a boundary patch, have in common, side by side.
struct LateralQuad
{
  std::array<Index, 4> corner{};                 // turned into the first prism; the diagonal is 1-3
  std::array<Index, 2> group{ None, None };      // the second is None on the boundary
  std::array<std::array<HalfFace, 2>, 2> half{}; // of each prism: its faces with the corners 0 and 2
  std::array<Index, 2> triangle{ None, None };   // of the boundary, or of a sheet, upon them
  bool isKept = true;                            // it becomes a quadrilateral of the result

  // Which of the two prisms g is.
  int sideOf(Index g) const { return group[0] == g ? 0 : 1; }
};

// Two or three tetrahedra of one prism, or the six of two that go together (Prisms/PrismJoints.h).
struct PrismGroup
{
  static constexpr int Most = 6;

  std::array<Index, Most> tet{};
  int size = 0;
  std::array<Index, Most> quad{};
  int quads = 0;

  int mostQuads() const { return size == Most ? Most : 3; }
};

struct PrismGroups
{
  std::vector<PrismGroup> groups;
  std::vector<Index> groupOf; // of each tetrahedron; None for those in no group
  std::vector<LateralQuad> quads;
};

// prism: of each tetrahedron, those of one prism share a number; negative for none. A boundary quadrilateral has
// one patch, and its halves turn by less than 30 degrees.
PrismGroups findPrismGroups(
  const MeshData& mesh, const FaceMatching& matching, const std::vector<Index>& prism);
} // namespace ransmesh

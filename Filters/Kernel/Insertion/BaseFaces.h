// The boundary faces that carry layers.
#pragma once

#include "Layers/Column.h"
#include "Mesh/TetMesh.h"

#include <array>
#include <vector>

namespace ransmesh
{
struct BaseFace
{
  Index face = None; // the boundary face
  int patch = 0;
  std::array<Index, 3> column; // on the corners, turned into the fluid; None where none stands
  std::array<int, 3> rise;     // corners in the order in which they rise at each level
  std::array<Index, 3> vertex; // the corners
  std::array<int, 3>
    sideOpposite{}; // patch beyond the edge opposite to the corner, where it is a side; else 0
};

// Does the face carry layers: has it a standing column for which its patch is not a side?
bool carriesLayers(const TetMesh& mesh, const ColumnSet& set, Index boundaryFace);

// All faces that carry layers, by number. Within a level columns rise in order of their number, in every
// face alike: that makes neighbouring stacks match.
std::vector<BaseFace> collectBaseFaces(const TetMesh& mesh, const ColumnSet& set);

// Gives every edge of a base face that has no base face beyond it the side patch that lies there.
void findSides(const TetMesh& mesh, const ColumnSet& set, std::vector<BaseFace>& faces);
} // namespace ransmesh

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
  // Is there a triangle of the wall below the face?
  bool hasBase() const { return root[0] != root[1] && root[1] != root[2] && root[2] != root[0]; }

  Index face = None; // the boundary face
  int patch = 0;
  std::array<Index, 3> column;  // on the corners, turned into the fluid; None where none stands
  std::array<int, 3> rise;      // corners in the order in which they rise at each level,
  std::array<int, 3> firstRise; // but at the first one
  std::array<Index, 3> vertex;  // the corners
  std::array<Index, 3> root;    // the wall's vertices below them; in a fan, corners share one
  std::array<int, 3>
    sideOpposite{}; // patch beyond the edge opposite to the corner, where it is a side; else 0
};

// Which corners of a stack still stand on the wall. As long as two of them share a root, the next
// tetrahedron of the stack has no volume and is left out.
class BaseCorners
{
public:
  explicit BaseCorners(const std::array<Index, 3>& root)
    : at_(root)
    , distinct_(root[0] != root[1] && root[1] != root[2] && root[2] != root[0])
  {
  }
  bool isFlat() const { return !distinct_ && (at_[0] == at_[1] || at_[1] == at_[2] || at_[2] == at_[0]); }
  void rise(int corner) { at_[corner] = -2 - corner; }

private:
  std::array<Index, 3> at_; // roots, or a number of its own for a corner that has risen
  bool distinct_;
};

// Where the face's corners stand on the wall.
std::array<Vector3, 3> basePoints(const TetMesh& mesh, const ColumnSet& set, const BaseFace& face);

// Whether columns of corners between walls of different heights rise before this one, within a level. column: None for
// a bare vertex.
bool risesLater(const ColumnSet& set, Index column);

// Of the column; 0 for a bare vertex.
int firstRankOf(const ColumnSet& set, Index column);

// All faces that carry layers, those with a standing column for which their patch is not a side, by number.
// Within a level columns rise in order of their roots' numbers, then of their own, in every face alike: that makes
// neighbouring stacks match. Those of corners between walls of different heights rise first: they lean over the lower
// wall, and would pass below its higher columns if these were there before them. In the first level their ranks
// come first (FirstRise.h). That those of one root rise one after
// the other keeps the bottoms of fans from having flat tetrahedra.
std::vector<BaseFace> collectBaseFaces(const TetMesh& mesh, const ColumnSet& set);

// Puts the corners in order for the first level, after the columns' ranks.
void sortFirstRise(const ColumnSet& set, BaseFace& face);

// faces: all of them, as collectBaseFaces gives them. Gives every edge of a base face that has no base face beyond it
// the side patch that lies there.
void findSides(const TetMesh& mesh, const ColumnSet& set, std::vector<BaseFace>& faces);
} // namespace ransmesh

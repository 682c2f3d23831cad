// Which tensor corners get their grids.
#pragma once

#include "Insertion/BaseFaces.h"
#include "Layers/Column.h"

#include <array>
#include <cstddef>
#include <vector>

namespace ransmesh
{
struct GridReport
{
  std::size_t planned = 0; // corners that have layers
  // Of them. The rest has no room: the layers are too thick for the ridge's neighbours, or the walls too round.
  std::size_t made = 0;
  std::size_t lostPoints = 0; // of grids whose corner's top got stuck
};

// Unit; zero for a triangle without area.
Vector3 normalOf(const std::array<Vector3, 3>& triangle);

// Decided from the front's topology: a corner's ridges must be ridges at their other ends too, go on or end in
// a side, and no fan may stand there.
class CornerChoice
{
public:
  // mesh: with the front where it is to stay; corners whose tops are not at their full height have no grid.
  CornerChoice(const TetMesh& mesh, const ColumnSet& set, const std::vector<BaseFace>& faces);

  // How many corners have their grids.
  std::size_t count() const;
  void drop(Index corner) { states_[corner].active = false; }
  // Drops corners until those that remain agree with their neighbours.
  void settle();
  const GridReport& report() const { return report_; }

  // The corner that the face's column j has its grid at, or None.
  Index at(const BaseFace& face, int j) const
  {
    const Index c = face.column[j] == None ? None : ofColumn_[face.column[j]];
    return c != None && states_[c].active ? c : None;
  }
  // The corner's wall that the face belongs to.
  int wallAt(Index corner, const BaseFace& face) const
  {
    return set_.corners[corner].wallOf(normalOf(basePoints(face)));
  }
  std::array<Vector3, 3> basePoints(const BaseFace& face) const
  {
    return ransmesh::basePoints(mesh_, set_, face);
  }
  // Is the edge opposite to corner j of a face a ridge at one of its ends?
  bool isRidge(Index face, int j) const;

private:
  struct FrontEdge
  {
    Index low;
    Index high;
    std::array<Index, 2> face{ None, None }; // on its two sides
  };
  struct CornerState
  {
    bool active = true;
    int ridges = 0; // ridge edges that meet here
  };

  void findEdges();
  bool isRidgeAt(const FrontEdge& edge, Index end) const;
  void countRidges(bool& changed);
  int ridgesWanted(Index corner) const;

  const TetMesh& mesh_;
  const ColumnSet& set_;
  const std::vector<BaseFace>& faces_;
  std::vector<Index> ofColumn_;
  std::vector<CornerState> states_;
  GridReport report_;
  std::vector<FrontEdge> edges_;
  std::vector<Index> edgeOf_; // 3 * face + corner opposite
};
} // namespace ransmesh

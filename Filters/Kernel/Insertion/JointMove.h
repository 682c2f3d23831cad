// One sweep of the front: all tops move at once, and those whose tetrahedra suffer are taken back.
#pragma once

#include "Insertion/Front.h"
#include "Insertion/SideTurns.h"

#include <vector>

namespace ransmesh
{
class JointMove
{
public:
  JointMove(TetMesh& mesh, const ColumnSet& set, const SideTurns& turns, Front& front)
    : mesh_(mesh)
    , set_(set)
    , turns_(turns)
    , front_(front)
  {
  }

  // Moves every top to its target share, if that is above the one that it has; leaves out those that
  // would fold the slab, turn a curved side away from its surface, turn a tetrahedron over or make a poor one poorer. Gives the number moved.
  std::size_t run(const std::vector<double>& target);

private:
  void place(const std::vector<double>& target);
  std::vector<Index> tetsAtMovedTops() const;
  bool takeBackAtFoldedFaces();
  std::vector<Index> sideFacesAtMovedTops() const;
  bool takeBackAtTurnedFaces(const std::vector<Index>& sideFaces);
  bool isTurned(Index sideFace) const;
  bool takeBackAtSpoiledTets(const std::vector<Index>& tets);
  bool isSpoiled(const std::array<Index, 4>& vertices) const;
  void takeBack(Index column);
  bool hasMoved(Index column) const { return column != None && moved_[column] != 0; }
  Vector3 before(Index vertex) const;

  TetMesh& mesh_;
  const ColumnSet& set_;
  const SideTurns& turns_;
  Front& front_;
  std::vector<char> moved_;
  std::vector<double> oldShare_;
  std::vector<Vector3> oldPosition_;
};
} // namespace ransmesh

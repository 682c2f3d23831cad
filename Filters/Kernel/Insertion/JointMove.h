// One sweep of the front: all tops move at once, and those whose tetrahedra suffer are taken back.
#pragma once

#include "Insertion/Front.h"
#include "Insertion/SideTurns.h"

#include <span>
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
  // would fold the slab, turn a curved side away from its surface, turn a tetrahedron over or make a poor
  // one poorer. Gives the number moved.
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
  void takeBack(Index vertex);
  Vector3 before(Index vertex) const;

  bool hasMoved(Index vertex) const { return moved_[vertex] != 0; }
  // Is there a vertex that has moved, and one whose place has changed since the last look at these?
  bool isConcerned(std::span<const Index> vertices) const;

  TetMesh& mesh_;
  const ColumnSet& set_;
  const SideTurns& turns_;
  Front& front_;
  // By vertex, not by column: they stay in the cache while all tetrahedra pass by.
  std::vector<char> moved_;
  std::vector<int> lastChange_; // the round in which the vertex was taken back; 0 if it moved, Never
  int round_ = 0;               // from 1
  static constexpr int Never = -1;
  // By column.
  std::vector<double> oldShare_;
  std::vector<Vector3> oldPosition_;
};
} // namespace ransmesh

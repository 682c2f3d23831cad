// One sweep of the front: all tops move at once, and those whose tetrahedra suffer are taken back.
#pragma once

#include "Insertion/Front.h"
#include "Insertion/SideTurns.h"
#include "Mesh/Traversal.h"
#include "Support/WorkRounds.h"

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
    , traversal_(mesh)
  {
  }

  // Moves every top to its target share, if that is above the one that it has; leaves out those that
  // would fold the slab, turn a curved side away from its surface, turn a tetrahedron over or make a poor
  // one poorer. Gives the number moved.
  std::size_t run(const std::vector<double>& target);

private:
  void place(const std::vector<double>& target);
  void collectWork();
  void collectTets();
  void collectSideFaces();
  bool takeBackAtFoldedFaces();
  bool takeBackAtSpoiledTets();
  bool takeBackAtTurnedFaces();
  bool isTurned(Index sideFace) const;
  bool isSpoiled(const std::array<Index, 4>& vertices) const;
  void takeBackAll(std::span<const Index> vertices);
  void takeBack(Index vertex);
  Vector3 before(Index vertex) const;

  bool hasMoved(Index vertex) const { return moved_[vertex] != 0; }
  bool anyHasMoved(std::span<const Index> vertices) const;

  TetMesh& mesh_;
  const ColumnSet& set_;
  const SideTurns& turns_;
  Front& front_;
  Traversal traversal_;
  std::vector<char> moved_; // by vertex, not by column: they stay in the cache while all tetrahedra pass by
  std::vector<Index> movedColumns_;
  // What may not stand with the tops where they are.
  WorkRounds faces_;
  WorkRounds tets_;
  WorkRounds sideFaces_;
  std::vector<Index> ball_;
  // By column.
  std::vector<double> oldShare_;
  std::vector<Vector3> oldPosition_;
};
} // namespace ransmesh

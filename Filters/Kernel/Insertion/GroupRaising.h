// Tops that are stuck, raised again together with what stands around them.
//
// A stuck top is closed in by others that rose before it. While a group of tops stands at one height the front there
// is the wall's own surface, lifted, and each of them sees its surroundings. So the tops around a stuck one are lowered
// to the lowest of them, and rise again side by side in many small steps. What becomes no better by that is undone.
#pragma once

#include "Insertion/Front.h"
#include "Insertion/FrontMoves.h"
#include "Layers/Column.h"
#include "Mesh/TetMesh.h"
#include "Mesh/Traversal.h"
#include "Support/Context.h"

#include <vector>

namespace ransmesh
{
class GroupRaising
{
public:
  GroupRaising(TetMesh& mesh, const ColumnSet& set, Front& front, FrontMoves& moves)
    : mesh_(mesh)
    , set_(set)
    , front_(front)
    , moves_(moves)
    , traversal_(mesh)
  {
  }

  // Tries all tops that do not reach their columns' last levels. The mesh is valid at every moment, and no group ends with fewer levels than before. False if cancelled.
  bool run(const Context& context);

private:
  bool isStuck(Index column) const { return front_.levelsReached(column) < set_.columns[column].levels; }
  std::vector<Index> stuckColumns() const;
  std::vector<Index> groupOf(Index column);
  std::vector<Index> withRings(std::vector<Index> columns, int rings);
  template <class Condition>
  void addAround(std::vector<Index>& columns, std::size_t which, Condition isWanted);
  void tryTogether(const std::vector<Index>& columns);
  void lower(const std::vector<Index>& columns, double height);
  void raise(const std::vector<Index>& columns, double height);
  void raiseTowards(Index column, double share);
  bool moveTo(Index column, double share);
  double heightOf(Index column) const { return front_.share(column) * thicknessOf(column); }
  double thicknessOf(Index column) const { return set_.thickness(set_.columns[column]); }
  int levelsReached(const std::vector<Index>& columns) const;

  TetMesh& mesh_;
  const ColumnSet& set_;
  Front& front_;
  FrontMoves& moves_;
  Traversal traversal_;
  std::vector<char> isGrouped_; // by column: was it in a group of this round?
  std::vector<Index> ball_;
  std::size_t tried_ = 0; // columns in groups
};
} // namespace ransmesh

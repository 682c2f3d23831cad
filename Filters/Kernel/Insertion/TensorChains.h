// The chains of points that the stacks of tensor corners are made of: those of their grids, and those of columns and bare
// vertices as they are.
#pragma once

#include "Insertion/BaseFaces.h"
#include "Insertion/CornerChoice.h"
#include "Insertion/TensorGrid.h"
#include "Insertion/TensorStacks.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace ransmesh
{
// In which chains rise, as columns do in stacks without grids, which these meet.
struct ChainOrder
{
  bool isOfGrid = true;
  bool risesLater = true;
  int firstRank = 0; // counts in the first level
  Index root = None;
};

class TensorChains
{
public:
  // What is referred to must outlive the chains. They, and the points of the grids, are added to out.
  TensorChains(const ColumnSet& set, const ColumnPoints& numbers, const std::vector<Index>& baseNumber,
    const CornerChoice& choice, const std::vector<Vector3>& points, TensorStacks& out);

  // The number of levels of the corner's grid.
  int levels(Index corner) { return gridOf(corner).points.levels(); }

  // A place of the grid on the wall: so far from each of the wall's two (or one) ridges.
  static GridPlace placeOn(int wall, int first, int second);
  // The place of the grid on the wall that is farthest from the ridges.
  GridPlace outermost(Index corner, int wall);

  // The chain on the base point of the corner's grid, which lies on the wall.
  Index ofGrid(Index corner, const GridPlace& base, int wall, int patch);
  // The chain of a column as it is, or of a bare vertex.
  Index plain(const BaseFace& face, int j);
  // The chain at corner j of the face, where the corner's grid, if there is one, ends.
  Index outer(const BaseFace& face, int j, Index corner);

  // The points of a chain, from the wall up.
  const std::vector<Index>& at(Index chain) const { return out_.chains[chain]; }
  const ChainOrder& order(Index chain) const { return orders_[chain]; }
  const Vector3& point(Index number) const;

private:
  struct Grid
  {
    TensorGrid points;
    std::map<std::size_t, Index> chains; // by slot of the base point
  };

  Grid& gridOf(Index corner);
  Index add(std::vector<Index> points, const ChainOrder& order);

  const ColumnSet& set_;
  const ColumnPoints& numbers_;
  const std::vector<Index>& baseNumber_;
  const CornerChoice& choice_;
  const std::vector<Vector3>& points_;
  TensorStacks& out_;
  std::vector<std::optional<Grid>> grids_;
  std::map<std::pair<Index, Index>, Index> plain_;
  std::vector<ChainOrder> orders_;
};
} // namespace ransmesh

// The points of the tensor-product grid at one corner.
#pragma once

#include "Insertion/LayerStacks.h"
#include "Layers/Column.h"

#include <array>
#include <vector>

namespace ransmesh
{
// So many levels above each of the corner's walls; with two walls the third number is not used.
using GridPlace = std::array<int, 3>;

class TensorGrid
{
public:
  // Appends the points that the corner's own column does not have; they are numbered from firstNumber on, by
  // their place in points.
  TensorGrid(const ColumnSet& set, const TensorCorner& corner, const ColumnPoints& numbers,
    std::size_t firstNumber, std::vector<Vector3>& points);

  int levels() const { return levels_; }
  const TensorCorner& corner() const { return corner_; }
  // The points that stand on a wall above a base point, which is 0 levels above that wall: they end where
  // the other walls' share of the grid begins.
  std::vector<Index> chainAbove(GridPlace base, int wall) const;
  // A number for the place, unique in this grid.
  std::size_t slot(const GridPlace& place) const;

private:
  bool isDiagonal(const GridPlace& place) const;
  Vector3 pointAt(const ColumnSet& set, const GridPlace& place) const;

  TensorCorner corner_;
  int levels_;
  std::vector<Index> number_;
};
} // namespace ransmesh

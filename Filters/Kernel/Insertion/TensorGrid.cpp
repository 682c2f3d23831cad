#include "Insertion/TensorGrid.h"

#include <algorithm>

namespace ransmesh
{
TensorGrid::TensorGrid(const ColumnSet& set, const TensorCorner& corner, const ColumnPoints& numbers,
  std::size_t firstNumber, std::vector<Vector3>& points)
  : corner_(corner)
  , levels_(set.columns[corner.column].levels)
{
  const int last = corner.walls == 3 ? levels_ : 0;
  number_.resize(slot({ levels_, levels_, last }) + 1);
  for (int k = 0; k <= last; ++k)
  {
    for (int j = 0; j <= levels_; ++j)
    {
      for (int i = 0; i <= levels_; ++i)
      {
        const GridPlace place{ i, j, k };
        const bool isColumn = isDiagonal(place);
        number_[slot(place)] =
          isColumn ? numbers.at(corner.column, i) : static_cast<Index>(firstNumber + points.size());
        if (!isColumn)
        {
          points.push_back(pointAt(set, place));
        }
      }
    }
  }
}

bool TensorGrid::isDiagonal(const GridPlace& place) const
{
  return place[0] == place[1] && (corner_.walls == 2 || place[1] == place[2]);
}

Vector3 TensorGrid::pointAt(const ColumnSet& set, const GridPlace& place) const
{
  const Column& column = set.columns[corner_.column];
  Vector3 x = column.base;
  for (int w = 0; w < corner_.walls; ++w)
  {
    x += set.heights[corner_.patch[w]].height(place[w]) * corner_.rise[w];
  }
  return x;
}

std::size_t TensorGrid::slot(const GridPlace& place) const
{
  const auto size = static_cast<std::size_t>(levels_) + 1;
  return static_cast<std::size_t>(place[0]) +
    size * (static_cast<std::size_t>(place[1]) + size * static_cast<std::size_t>(place[2]));
}

std::vector<Index> TensorGrid::chainAbove(GridPlace base, int wall) const
{
  int height = levels_;
  for (int w = 0; w < corner_.walls; ++w)
  {
    height = w == wall ? height : std::min(height, base[w]);
  }
  std::vector<Index> chain;
  for (base[wall] = 0; base[wall] <= height; ++base[wall])
  {
    chain.push_back(number_[slot(base)]);
  }
  return chain;
}
} // namespace ransmesh

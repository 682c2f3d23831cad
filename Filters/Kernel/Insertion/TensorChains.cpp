#include "Insertion/TensorChains.h"

namespace ransmesh
{
TensorChains::TensorChains(const ColumnSet& set, const ColumnPoints& numbers,
  const std::vector<Index>& baseNumber, const CornerChoice& choice, const std::vector<Vector3>& points,
  TensorStacks& out)
  : set_(set)
  , numbers_(numbers)
  , baseNumber_(baseNumber)
  , choice_(choice)
  , points_(points)
  , out_(out)
  , grids_(set.corners.size())
{
}

TensorChains::Grid& TensorChains::gridOf(Index corner)
{
  if (!grids_[corner])
  {
    grids_[corner].emplace(
      Grid{ TensorGrid(set_, set_.corners[corner], numbers_, points_.size(), out_.points), {} });
    out_.origin.resize(out_.points.size(), { set_.corners[corner].column, None, 0 });
  }
  return *grids_[corner];
}

Index TensorChains::add(std::vector<Index> points, const ChainOrder& order)
{
  out_.chains.push_back(std::move(points));
  orders_.push_back(order);
  return static_cast<Index>(out_.chains.size() - 1);
}

Index TensorChains::ofGrid(Index corner, const GridPlace& base, int wall, int patch)
{
  Grid& grid = gridOf(corner);
  const auto [found, isNew] = grid.chains.try_emplace(grid.points.slot(base), None);
  if (isNew)
  {
    std::vector<Index> chain = grid.points.chainAbove(base, wall);
    const auto isGridPoint = static_cast<std::size_t>(chain[0]) >= points_.size();
    if (isGridPoint)
    {
      GridPoint& origin = out_.origin[static_cast<std::size_t>(chain[0]) - points_.size()];
      origin.layers = static_cast<int>(chain.size()) - 1;
      origin.patch = patch;
    }
    found->second = add(std::move(chain), { true, true, 0, set_.columns[set_.corners[corner].column].root });
  }
  return found->second;
}

Index TensorChains::plain(const BaseFace& face, int j)
{
  const auto [found, isNew] = plain_.try_emplace({ face.root[j], face.column[j] }, None);
  if (isNew)
  {
    std::vector<Index> chain{ baseNumber_[face.root[j]] };
    const int levels = face.column[j] == None ? 0 : set_.columns[face.column[j]].levels;
    for (int level = 1; level <= levels; ++level)
    {
      chain.push_back(numbers_.at(face.column[j], level));
    }
    found->second = add(std::move(chain),
      { false, risesLater(set_, face.column[j]), firstRankOf(set_, face.column[j]), face.root[j] });
  }
  return found->second;
}

GridPlace TensorChains::placeOn(int wall, int first, int second)
{
  GridPlace place{};
  place[(wall + 1) % 3] = first;
  place[(wall + 2) % 3] = second;
  return place;
}

GridPlace TensorChains::outermost(Index corner, int wall)
{
  const int levels = gridOf(corner).points.levels();
  GridPlace place = placeOn(wall, levels, levels);
  place[2] = set_.corners[corner].walls == 2 ? 0 : place[2];
  return place;
}

Index TensorChains::outer(const BaseFace& face, int j, Index corner)
{
  if (corner == None)
  {
    return plain(face, j);
  }
  const int wall = choice_.wallAt(corner, face);
  return ofGrid(corner, outermost(corner, wall), wall, face.patch);
}

const Vector3& TensorChains::point(Index number) const
{
  const auto n = static_cast<std::size_t>(number);
  return n < points_.size() ? points_[n] : out_.points[n - points_.size()];
}
} // namespace ransmesh

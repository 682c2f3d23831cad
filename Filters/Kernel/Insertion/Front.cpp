#include "Insertion/Front.h"

#include "Geometry/Predicates.h"
#include "Layers/ColumnLimits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ransmesh
{
namespace
{
// A last level's spacing may be so much shorter than the one asked for, as a share of it: with the usual growth
// it is then still about the one before.
constexpr double LeastLastSpacing = 0.8;
} // namespace

Front::Front(const TetMesh& mesh, const ColumnSet& set)
  : mesh_(mesh)
  , set_(set)
  , share_(set.columns.size(), 0)
  , faces_(collectBaseFaces(mesh, set))
  , start_(set.columns.size() + 1, 0)
{
  for (std::size_t c = 0; c < set.columns.size(); ++c)
  {
    const double thickness = set.thickness(set.columns[c]);
    share_[c] = thickness > 0 ? set.columns[c].lifted / thickness : 0;
  }
  base_.reserve(faces_.size());
  for (const BaseFace& face : faces_)
  {
    base_.push_back(basePoints(mesh, set, face));
  }
  const auto forEach = [this](auto visit)
  {
    for (std::size_t i = 0; i < faces_.size(); ++i)
    {
      for (const Index c : faces_[i].column)
      {
        if (c != None)
        {
          visit(c, static_cast<Index>(i));
        }
      }
    }
  };
  forEach([this](Index c, Index) { ++start_[c + 1]; });
  for (std::size_t i = 1; i < start_.size(); ++i)
  {
    start_[i] += start_[i - 1];
  }
  facesAt_.resize(start_.back());
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  forEach([&](Index c, Index face) { facesAt_[next[c]++] = face; });
}

Vector3 Front::position(Index column, double share) const
{
  const Column& c = set_.columns[column];
  return share >= 1 ? set_.pointAt(c, c.levels) : set_.pointAtHeight(c, share * set_.thickness(c));
}

int Front::levelsReached(Index column) const
{
  const Column& c = set_.columns[column];
  if (share_[column] >= 1)
  {
    return c.levels;
  }
  const double height = share_[column] * set_.thickness(c);
  const int below = levelBelow(set_, c, height);
  const LayerHeights& heights = set_.heightsOf(c);
  return height - heights.height(below) >= LeastLastSpacing * heights.spacing(below + 1) ? below + 1 : below;
}

double Front::shortestEdge(Index column) const
{
  double shortest = std::numeric_limits<double>::infinity();
  for (const Index f : facesAt(column))
  {
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const double length = distance(base_[f][i], base_[f][j]); // of columns on one root: 0
      const bool isAtColumn = faces_[f].column[i] == column || faces_[f].column[j] == column;
      shortest = isAtColumn && length > 0 ? std::min(shortest, length) : shortest;
    }
  }
  return std::isfinite(shortest) ? shortest : set_.columns[column].size;
}

bool Front::slabAllows(Index column, const Vector3& x) const
{
  return std::all_of(facesAt_.begin() + start_[column], facesAt_.begin() + start_[column + 1],
    [&](Index face) { return slabIsPositive(static_cast<std::size_t>(face), column, x); });
}

bool Front::slabIsPositive(std::size_t face) const
{
  return slabIsPositive(face, None, {});
}

bool Front::slabIsPositive(std::size_t number, Index moved, const Vector3& x) const
{
  const BaseFace& face = faces_[number];
  std::array<Vector3, 3> current = base_[number];
  BaseCorners corners(face.root);
  for (const int corner : face.rise)
  {
    const Index c = face.column[corner];
    if (c == None || (c != moved && share_[c] == 0))
    {
      continue;
    }
    const Vector3& top = c == moved ? x : mesh_.point(face.vertex[corner]);
    if (!corners.isFlat() && !isPositive(current[0], current[1], current[2], top))
    {
      return false;
    }
    corners.rise(corner);
    current[corner] = top;
  }
  return true;
}
} // namespace ransmesh

#include "Layers/ColumnLimits.h"

#include <algorithm>
#include <queue>

namespace ransmesh
{
namespace
{
constexpr double LargestSlope = 0.7;
} // namespace

int levelBelow(const ColumnSet& set, const Column& column, double height)
{
  const LayerHeights& heights = set.heightsOf(column);
  int level = column.levels;
  while (level > 0 && heights.height(level) > height)
  {
    --level;
  }
  return level;
}

void limitByIsotropicSize(const LayerPlan& plan, ColumnSet& set)
{
  for (Column& c : set.columns)
  {
    const LayerHeights& heights = set.heightsOf(c);
    const double largest = plan[c.patch].isotropicFraction * c.size;
    int level = c.levels;
    while (level > 0 && heights.spacing(level) > largest)
    {
      --level;
    }
    c.limit(level, StopReason::IsotropicSize);
  }
}

namespace
{
// Limits columns where the wall ends: beside them the front comes down to the bare surface.
void limitAtWallEnds(const TetMesh& mesh, const BoundaryStars& stars, ColumnSet& set)
{
  for (Column& c : set.columns)
  {
    for (const Index face : stars.facesAt(c.root))
    {
      if (c.levels == 0 || c.staysIn(mesh.boundaryFace(face).patch))
      {
        continue;
      }
      for (const Index v : mesh.boundaryVertices(face))
      {
        const double allowed = LargestSlope * distance(c.base, mesh.point(v));
        if (set.ofVertex[v] == None && set.thickness(c) > allowed)
        {
          c.limit(levelBelow(set, c, allowed), StopReason::Transition);
        }
      }
    }
  }
}
} // namespace

void limitBySlope(const TetMesh& mesh, const BoundaryStars& stars, ColumnSet& set)
{
  limitAtWallEnds(mesh, stars, set);
  double highest = 0;
  for (const Column& c : set.columns)
  {
    highest = std::max(highest, set.thickness(c));
  }
  // Lowest first, so that each column is settled when its turn comes (as Dijkstra's shortest paths).
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::size_t i = 0; i < set.columns.size(); ++i)
  {
    if (set.thickness(set.columns[i]) < highest)
    {
      queue.emplace(set.thickness(set.columns[i]), static_cast<Index>(i));
    }
  }
  while (!queue.empty())
  {
    const auto [height, i] = queue.top();
    queue.pop();
    const Column& c = set.columns[i];
    if (height > set.thickness(c))
    {
      continue;
    }
    for (const Index face : stars.facesAt(c.root))
    {
      for (const Index v : mesh.boundaryVertices(face))
      {
        const Index j = set.standingAt(v);
        if (j == None || j == i)
        {
          continue;
        }
        Column& other = set.columns[j];
        const double allowed = height + LargestSlope * distance(c.base, other.base);
        if (set.thickness(other) > allowed)
        {
          other.limit(levelBelow(set, other, allowed), StopReason::Transition);
          queue.emplace(set.thickness(other), j);
        }
      }
    }
  }
}
} // namespace ransmesh

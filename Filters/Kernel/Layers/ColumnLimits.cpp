#include "Layers/ColumnLimits.h"

#include <algorithm>
#include <queue>

namespace ransmesh
{
namespace
{
constexpr double LargestSlope = 1.0;
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

void limitBySlope(const TetMesh& mesh, const BoundaryStars& stars, ColumnSet& set)
{
  // Lowest first, so that each column is settled when its turn comes (as Dijkstra's shortest paths).
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::size_t i = 0; i < set.columns.size(); ++i)
  {
    if (set.columns[i].levels < set.columns[i].asked)
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
    for (const Index face : stars.facesAt(c.vertex))
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

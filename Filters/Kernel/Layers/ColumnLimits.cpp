#include "Layers/ColumnLimits.h"

#include <algorithm>
#include <queue>

namespace ransmesh
{
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

namespace
{
// Grids bring points to walls at the patches' heights, and bends have places of their own. Where layers are lost anyway
// the rest keep their heights: fronts that come nearer to each other in narrow slots left more tops behind.
bool canBeSqueezed(const ColumnSet& set, const Column& column, double height)
{
  return !column.hasGrid && column.bend == None && column.levels > 0 && column.levels == column.asked &&
    set.heights[column.patch].squeezedHeight(column.levels) <= height;
}
} // namespace

void limitHeight(ColumnSet& set, Column& column, double height, StopReason why)
{
  if (set.thickness(column) <= height)
  {
    return;
  }
  if (!canBeSqueezed(set, column, height))
  {
    column.limit(levelBelow(set, column, height), why);
    return;
  }
  // In a fan columns share their heights until one is lowered.
  column.squeezed = static_cast<Index>(set.squeezed.size());
  set.squeezed.push_back(set.heights[column.patch].squeezed(column.levels, height));
}

void limitByIsotropicSize(const LayerPlan& plan, ColumnSet& set)
{
  for (Column& c : set.columns)
  {
    const int level = levelsOfIsotropicSize(set.heightsOf(c), plan[c.patch].isotropicFraction, c.size);
    c.limit(level, StopReason::IsotropicSize);
  }
  for (const TensorCorner& corner : set.corners)
  {
    Column& c = set.columns[corner.column];
    for (int w = 0; w < corner.walls; ++w)
    {
      const int patch = corner.patch[w];
      const int level = levelsOfIsotropicSize(set.heights[patch], plan[patch].isotropicFraction, c.size);
      c.limit(level, StopReason::IsotropicSize);
    }
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
          limitHeight(set, c, allowed, StopReason::Transition);
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
  // Lowest first, so that each column is settled when its turn comes (as Dijkstra's shortest paths). What
  // spreads is the height that is allowed, not that of the level below it: where edges are shorter than a
  // layer is high, levels would never rise again.
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::vector<double> reach;
  reach.reserve(set.columns.size());
  for (const Column& c : set.columns)
  {
    reach.push_back(set.thickness(c));
    if (reach.back() < highest || c.bend != None)
    {
      queue.emplace(reach.back(), static_cast<Index>(reach.size() - 1));
    }
  }
  while (!queue.empty())
  {
    const auto [height, i] = queue.top();
    queue.pop();
    const Column& c = set.columns[i];
    if (height > reach[i])
    {
      continue;
    }
    for (const Index face : stars.facesAt(c.root))
    {
      const int patch = mesh.boundaryFace(face).patch;
      if (c.staysIn(patch)) // beside the layers, not below them
      {
        continue;
      }
      for (const Index v : mesh.boundaryVertices(face))
      {
        const Index j = set.standingAt(v);
        if (j == None || j == i)
        {
          continue;
        }
        Column& other = set.columns[j];
        const double allowed =
          (height * set.shareOver(patch, c) + LargestSlope * distance(c.base, other.base)) /
          set.shareOver(patch, other);
        if (reach[j] > allowed)
        {
          reach[j] = allowed;
          limitHeight(set, other, allowed, StopReason::Transition);
          queue.emplace(allowed, j);
        }
      }
    }
  }
}
} // namespace ransmesh

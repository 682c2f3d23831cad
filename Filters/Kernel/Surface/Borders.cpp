#include "Surface/Borders.h"

#include "Triangles/SurfaceEdges.h"

#include <algorithm>
#include <map>

namespace ransmesh
{
namespace
{
class BorderWalk
{
public:
  explicit BorderWalk(const SurfaceMesh& surface)
    : surface_(surface)
  {
    forEachEdge(sortedEdges(surface),
      [&](const SurfaceEdge* first, const SurfaceEdge* last)
      {
        if (last - first == 1)
        {
          next_.emplace(first->forward ? first->a : first->b, first->forward ? first->b : first->a);
        }
      });
  }

  std::vector<BorderLoop> run()
  {
    for (const Index start : startsOfChains())
    {
      walk(start);
    }
    while (!next_.empty())
    {
      walk(next_.begin()->first);
    }
    return std::move(loops_);
  }

private:
  // Points from which more open edges start than end: chains are walked whole, before closed loops.
  std::vector<Index> startsOfChains() const
  {
    std::map<Index, int> surplus;
    for (const auto& [from, to] : next_)
    {
      ++surplus[from];
      --surplus[to];
    }
    std::vector<Index> starts;
    for (const auto& [point, more] : surplus)
    {
      starts.insert(starts.end(), static_cast<std::size_t>(std::max(more, 0)), point);
    }
    return starts;
  }

  void walk(Index start)
  {
    std::vector<Index> path = { start };
    std::map<Index, std::size_t> placeOnPath = { { start, 0 } };
    for (auto edge = next_.find(start); edge != next_.end(); edge = next_.find(path.back()))
    {
      const Index to = edge->second;
      next_.erase(edge);
      const auto known = placeOnPath.find(to);
      if (known == placeOnPath.end())
      {
        placeOnPath[to] = path.size();
        path.push_back(to);
        continue;
      }
      const std::vector<Index> loop(path.begin() + static_cast<std::ptrdiff_t>(known->second), path.end());
      keep(loop, true);
      for (std::size_t i = known->second + 1; i < path.size(); ++i)
      {
        placeOnPath.erase(path[i]);
      }
      path.resize(known->second + 1);
    }
    if (path.size() > 1)
    {
      keep(path, false);
    }
  }

  void keep(const std::vector<Index>& points, bool closed)
  {
    std::vector<Vector3> places;
    places.reserve(points.size());
    for (const Index v : points)
    {
      places.push_back(surface_.points[v]);
    }
    loops_.push_back({ points, closed, extentOf(places) });
  }

  const SurfaceMesh& surface_;
  std::multimap<Index, Index> next_; // the open edges that are not in a loop yet
  std::vector<BorderLoop> loops_;
};
} // namespace

std::vector<BorderLoop> findBorders(const SurfaceMesh& surface)
{
  return BorderWalk(surface).run();
}

std::vector<char> borderPoints(const SurfaceMesh& surface)
{
  std::vector<char> isBorder(surface.points.size(), 0);
  forEachEdge(sortedEdges(surface),
    [&](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      if (last - first == 1)
      {
        isBorder[first->a] = isBorder[first->b] = 1;
      }
    });
  return isBorder;
}
} // namespace ransmesh

#include "Surface/ShortEdges.h"

#include "Triangles/SurfaceEdges.h"
#include "Triangles/SurfaceRepair.h"
#include "Triangles/SurfaceTriangles.h"

#include <set>

namespace ransmesh
{
namespace
{
// One pass over the short edges; edges whose ends an earlier one has touched wait for the next pass.
class CollapsePass
{
public:
  explicit CollapsePass(SurfaceMesh& surface)
    : surface_(surface)
    , ofPoint_(surface.points.size())
    , isTouched_(surface.points.size(), 0)
    , stays_(surface.triangles.size(), 1)
  {
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      for (const Index v : surface.triangles[t])
      {
        ofPoint_[v].push_back(static_cast<Index>(t));
      }
    }
  }

  CollapseReport run(double shortest)
  {
    CollapseReport report;
    forEachEdge(sortedEdges(surface_),
      [&](const SurfaceEdge* first, const SurfaceEdge* last)
      {
        const Vector3 place = surface_.points[first->a];
        if (last - first == 2 && distance(place, surface_.points[first->b]) < shortest &&
          (collapse(first->a, first->b) || collapse(first->b, first->a)))
        {
          report.where = report.edges++ == 0 ? place : report.where;
        }
      });
    keepTriangles(surface_, stays_);
    return report;
  }

private:
  bool has(Index t, Index v) const
  {
    const auto& c = surface_.triangles[t];
    return c[0] == v || c[1] == v || c[2] == v;
  }

  std::set<Index> neighboursOf(Index v) const
  {
    std::set<Index> neighbours;
    for (const Index t : ofPoint_[v])
    {
      neighbours.insert(surface_.triangles[t].begin(), surface_.triangles[t].end());
    }
    neighbours.erase(v);
    return neighbours;
  }

  std::set<int> patchesAt(Index v) const
  {
    std::set<int> patches;
    for (const Index t : ofPoint_[v])
    {
      patches.insert(surface_.patch[t]);
    }
    return patches;
  }

  // Moves `from` to `to`.
  bool collapse(Index to, Index from)
  {
    const std::set<Index> ring = neighboursOf(from);
    if (isTouched_[to] || isTouched_[from] || !keepsTopology(to, ring) || !keepsPatches(to, from) ||
      turnsOver(to, from))
    {
      return false;
    }
    for (const Index t : ofPoint_[from])
    {
      stays_[t] = !has(t, to) && stays_[t];
      for (Index& v : surface_.triangles[t])
      {
        v = v == from ? to : v;
      }
    }
    isTouched_[to] = isTouched_[from] = 1;
    for (const Index v : ring)
    {
      isTouched_[v] = 1;
    }
    return true;
  }

  // The ends have no common neighbours but the two opposite to the edge.
  bool keepsTopology(Index to, const std::set<Index>& ring) const
  {
    const std::set<Index> other = neighboursOf(to);
    std::size_t common = 0;
    for (const Index v : ring)
    {
      common += other.contains(v);
    }
    return common == 2 && ring.size() > 2 && other.size() > 2;
  }

  bool keepsPatches(Index to, Index from) const
  {
    const std::set<int> kept = patchesAt(to);
    const std::set<int> moved = patchesAt(from);
    return std::includes(kept.begin(), kept.end(), moved.begin(), moved.end());
  }

  bool turnsOver(Index to, Index from) const
  {
    for (const Index t : ofPoint_[from])
    {
      if (has(t, to))
      {
        continue;
      }
      Corners moved = surface_.triangles[t];
      std::replace(moved.begin(), moved.end(), from, to);
      if (dot(areaVector(surface_, moved), areaVector(surface_, surface_.triangles[t])) <= 0)
      {
        return true;
      }
    }
    return false;
  }

  SurfaceMesh& surface_;
  std::vector<std::vector<Index>> ofPoint_;
  std::vector<char> isTouched_;
  std::vector<char> stays_;
};
} // namespace

CollapseReport collapseShortEdges(SurfaceMesh& surface, double shortest)
{
  CollapseReport all;
  constexpr int mostPasses = 50;
  for (int pass = 0; pass < mostPasses && shortest > 0; ++pass)
  {
    const CollapseReport report = CollapsePass(surface).run(shortest);
    if (report.edges == 0)
    {
      break;
    }
    all.where = all.edges == 0 ? report.where : all.where;
    all.edges += report.edges;
    mergeEqualPoints(surface); // drops the points that are not used any more
  }
  return all;
}
} // namespace ransmesh

#include "Surface/Folds.h"

#include "Triangles/SurfaceEdges.h"
#include "Triangles/SurfaceRepair.h"

#include <map>
#include <numeric>

namespace ransmesh
{
namespace
{
// Sets of equal triangles that hang together by edges are dealt with as one.
class DuplicateSets
{
public:
  explicit DuplicateSets(const SurfaceMesh& surface)
    : surface_(surface)
    , first_(firstOfEqual(surface))
    , copies_(surface.triangles.size(), 0)
    , parent_(surface.triangles.size())
  {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (const Index f : first_)
    {
      ++copies_[f];
    }
    join();
  }

  // A flag a triangle: whether it stays.
  std::vector<char> decide(double largestFold, DuplicateReport& report)
  {
    std::vector<char> stays(first_.size(), 1);
    for (auto& [root, set] : sets_)
    {
      const bool isFold = set.oddWithoutAny < set.oddWithOne && set.extent.largestLength() <= largestFold;
      for (const Index t : set.triangles)
      {
        stays[t] = !isFold && first_[t] == t;
        const std::size_t gone = stays[t] ? 0 : 1;
        report.where = gone && report.dropped + report.folded == 0 ? centreOf(surface_, t) : report.where;
        (isFold ? report.folded : report.dropped) += gone;
      }
    }
    return stays;
  }

private:
  struct Set
  {
    std::vector<Index> triangles;
    std::size_t oddWithOne = 0;    // edges of an odd number of triangles, if one copy of each stays
    std::size_t oddWithoutAny = 0; // if none does
    Extent extent;
  };

  bool isDuplicate(Index t) const { return copies_[first_[t]] > 1; }

  Index root(Index t)
  {
    while (parent_[t] != t)
    {
      t = parent_[t] = parent_[parent_[t]];
    }
    return t;
  }

  void join()
  {
    const std::vector<SurfaceEdge> edges = sortedEdges(surface_);
    forEachEdge(edges,
      [&](const SurfaceEdge* first, const SurfaceEdge* last)
      {
        const SurfaceEdge* duplicate = nullptr;
        for (const SurfaceEdge* e = first; e < last; ++e)
        {
          if (isDuplicate(e->triangle))
          {
            duplicate = duplicate ? duplicate : e;
            parent_[root(e->triangle)] = root(duplicate->triangle);
          }
        }
      });
    for (std::size_t t = 0; t < first_.size(); ++t)
    {
      if (isDuplicate(static_cast<Index>(t)))
      {
        add(static_cast<Index>(t));
      }
    }
    forEachEdge(edges, [&](const SurfaceEdge* first, const SurfaceEdge* last) { count(first, last); });
  }

  void add(Index t)
  {
    Set& set = sets_[root(t)];
    if (set.triangles.empty())
    {
      const Vector3& p = surface_.points[surface_.triangles[t][0]];
      set.extent = { p, p };
    }
    for (const Index v : surface_.triangles[t])
    {
      const Vector3& p = surface_.points[v];
      for (int k = 0; k < 3; ++k)
      {
        set.extent.low[k] = std::fmin(set.extent.low[k], p[k]);
        set.extent.high[k] = std::fmax(set.extent.high[k], p[k]);
      }
    }
    set.triangles.push_back(t);
  }

  void count(const SurfaceEdge* first, const SurfaceEdge* last)
  {
    Index duplicate = None;
    int withOne = 0;
    int withoutAny = 0;
    for (const SurfaceEdge* e = first; e < last; ++e)
    {
      const bool isDouble = isDuplicate(e->triangle);
      duplicate = isDouble ? e->triangle : duplicate;
      withOne += !isDouble || first_[e->triangle] == e->triangle;
      withoutAny += !isDouble;
    }
    if (duplicate != None)
    {
      Set& set = sets_[root(duplicate)];
      set.oddWithOne += withOne % 2;
      set.oddWithoutAny += withoutAny % 2;
    }
  }

  const SurfaceMesh& surface_;
  std::vector<Index> first_;
  std::vector<int> copies_;
  std::vector<Index> parent_;
  std::map<Index, Set> sets_;
};
} // namespace

DuplicateReport dropDuplicates(SurfaceMesh& surface, double largestFold)
{
  DuplicateReport report;
  const std::vector<char> stays = DuplicateSets(surface).decide(largestFold, report);
  keepTriangles(surface, stays);
  return report;
}
} // namespace ransmesh

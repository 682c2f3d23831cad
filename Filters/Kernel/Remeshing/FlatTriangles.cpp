#include "Remeshing/FlatTriangles.h"

#include "Triangles/SurfaceEdges.h"
#include "Triangles/SurfaceTriangles.h"

namespace ransmesh
{
namespace
{
// More rounds gain little and make shorter and shorter edges: each split may need another next to it.
constexpr int MostRounds = 4;

// The triangles to be split, the worst first.
std::vector<Index> flatTriangles(const SurfaceMesh& surface)
{
  const double shortest = ShortestSplit * extentOf(surface.points).largestLength();
  std::vector<std::pair<double, Index>> flat;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const double angle = largestAngle(surface, surface.triangles[t]);
    if (angle > SplitTriangleAngle && smallestHeight(surface, surface.triangles[t]) >= shortest)
    {
      flat.emplace_back(-angle, static_cast<Index>(t));
    }
  }
  std::sort(flat.begin(), flat.end());
  std::vector<Index> triangles;
  triangles.reserve(flat.size());
  for (const auto& [angle, t] : flat)
  {
    triangles.push_back(t);
  }
  return triangles;
}

class Splitting
{
public:
  Splitting(SurfaceMesh& surface, const std::vector<char>& keep)
    : surface_(surface)
    , keep_(keep)
    , edges_(sortedEdges(surface))
    , isUsed_(surface.triangles.size(), 0)
  {
  }

  // Whether the longest side of a triangle could be split.
  bool split(Index triangle)
  {
    const Corners t = surface_.triangles[triangle];
    int apex = 0;
    for (int i = 1; i < 3; ++i)
    {
      apex = angleAt(surface_, t, i) > angleAt(surface_, t, apex) ? i : apex;
    }
    const Index a = std::min(t[(apex + 1) % 3], t[(apex + 2) % 3]);
    const Index b = std::max(t[(apex + 1) % 3], t[(apex + 2) % 3]);
    const std::vector<Index> around = trianglesAt(a, b);
    if ((keep_[a] && keep_[b]) ||
      std::any_of(around.begin(), around.end(), [this](Index s) { return isUsed_[s] != 0; }))
    {
      return false;
    }
    const Index foot = addFoot(a, b, t[apex]);
    for (const Index s : around)
    {
      splitTriangle(s, a, b, foot);
    }
    return true;
  }

private:
  std::vector<Index> trianglesAt(Index a, Index b) const
  {
    auto edge = std::lower_bound(edges_.begin(), edges_.end(), std::pair(a, b),
      [](const SurfaceEdge& e, const auto& key)
      { return std::tie(e.a, e.b) < std::tie(key.first, key.second); });
    std::vector<Index> triangles;
    for (; edge != edges_.end() && edge->a == a && edge->b == b; ++edge)
    {
      triangles.push_back(edge->triangle);
    }
    return triangles;
  }

  Index addFoot(Index a, Index b, Index apex)
  {
    auto& p = surface_.points;
    const Vector3 side = p[b] - p[a];
    const double part = dot(p[apex] - p[a], side) / dot(side, side);
    p.push_back(p[a] + part * side);
    return static_cast<Index>(p.size() - 1);
  }

  // The two halves of a triangle: each has the new point in the place of one end of the side.
  void splitTriangle(Index triangle, Index a, Index b, Index foot)
  {
    Corners half = surface_.triangles[triangle];
    std::replace(surface_.triangles[triangle].begin(), surface_.triangles[triangle].end(), a, foot);
    std::replace(half.begin(), half.end(), b, foot);
    const int patch = surface_.patch[triangle];
    surface_.triangles.push_back(half);
    surface_.patch.push_back(patch);
    isUsed_[triangle] = 1;
  }

  SurfaceMesh& surface_;
  const std::vector<char>& keep_;
  std::vector<SurfaceEdge> edges_; // as they were at the beginning
  std::vector<char> isUsed_;
};
} // namespace

std::size_t splitFlatTriangles(SurfaceMesh& surface, const std::vector<char>& keep)
{
  Splitting splitting(surface, keep);
  std::size_t splits = 0;
  for (const Index t : flatTriangles(surface))
  {
    splits += splitting.split(t) ? 1 : 0;
  }
  return splits;
}

FlatTriangleReport mendFlatTriangles(
  SurfaceMesh& surface, double angle, std::vector<char> keep, bool maySplit)
{
  keep.resize(surface.points.size(), 0);
  SwapReport swapped = swapDiagonals(surface, angle, keep);
  FlatTriangleReport report;
  report.largestBefore = swapped.largestBefore;
  report.flatBefore = swapped.flatBefore;
  report.isRefused = swapped.isRefused;
  report.swaps = swapped.swaps;
  report.largestShift = swapped.largestShift;
  for (int round = 0; maySplit && swapped.largestAfter > SplitTriangleAngle && round < MostRounds; ++round)
  {
    report.splits += splitFlatTriangles(surface, keep);
    keep.resize(surface.points.size(), 0);
    swapped = swapDiagonals(surface, angle, keep);
    report.swaps += swapped.swaps;
    report.largestShift = std::fmax(report.largestShift, swapped.largestShift);
  }
  report.largestAfter = swapped.largestAfter;
  report.flatAfter = swapped.flatAfter;
  return report;
}
} // namespace ransmesh

#include "Remeshing/SurfaceReference.h"

#include "Remeshing/SurfaceSwaps.h"

namespace ransmesh
{
// Triangles so low that they have no normal are left out: their neighbours are as near. Patches that have no
// others get theirs.
std::map<int, TriangleTree> SurfaceReference::treesOf(const SurfaceMesh& surface)
{
  const double lowest = LineHeight * extentOf(surface.points).largestLength();
  std::map<int, std::vector<Index>> good;
  std::map<int, std::vector<Index>> all;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    all[surface.patch[t]].push_back(static_cast<Index>(t));
    if (smallestHeight(surface, surface.triangles[t]) > lowest)
    {
      good[surface.patch[t]].push_back(static_cast<Index>(t));
    }
  }
  good.merge(all);
  std::map<int, TriangleTree> trees;
  for (const auto& [patch, triangles] : good)
  {
    trees.try_emplace(patch, surface, triangles);
  }
  return trees;
}

SurfaceReference::SurfaceReference(const EditableSurface& given)
  : surface_(given.surface())
  , lines_{ surface_.points, {}, {} }
  , trees_(treesOf(surface_))
{
  std::vector<std::vector<Index>> edges(given.lineCount());
  for (const Corners& t : surface_.triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Index a = t[i];
      const Index b = t[(i + 1) % 3];
      if (const Index line = given.lineOf(a, b); line != None)
      {
        edges[line].push_back(static_cast<Index>(lines_.triangles.size()));
        lines_.triangles.push_back({ a, b, b });
        lines_.patch.push_back(line);
      }
    }
  }
  for (std::vector<Index>& line : edges)
  {
    lineTrees_.emplace_back(lines_, std::move(line));
  }
}

ReferencePoint SurfaceReference::closestOnPatch(const Vector3& p, int patch) const
{
  ReferencePoint closest{ p, {}, None };
  if (const auto found = trees_.find(patch); found != trees_.end())
  {
    closest.triangle = found->second.closest(closest.place);
    closest.normal = normalized(areaVector(surface_, surface_.triangles[closest.triangle]));
  }
  return closest;
}

LinePoint SurfaceReference::closestOnLine(const Vector3& p, Index line) const
{
  LinePoint closest{ p, 0 };
  if (const Index edge = lineTrees_[line].closest(closest.place); edge != None)
  {
    const Corners& ends = lines_.triangles[edge];
    closest.edge = distance(lines_.points[ends[0]], lines_.points[ends[1]]);
  }
  return closest;
}

SurfaceDeviation deviationFrom(const SurfaceReference& reference, const SurfaceMesh& surface)
{
  SurfaceDeviation deviation;
  double sum = 0;
  const auto look = [&](const Vector3& p, int patch)
  {
    const double far = distance(p, reference.closestOnPatch(p, patch).place);
    sum += far;
    if (far > deviation.largest)
    {
      deviation.largest = far;
      deviation.place = p;
    }
  };
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const int patch = surface.patch[t];
    const Corners& v = surface.triangles[t];
    look(centreOf(surface, static_cast<Index>(t)), patch);
    for (int i = 0; i < 3; ++i)
    {
      look(surface.points[v[i]], patch);
      look(0.5 * (surface.points[v[i]] + surface.points[v[(i + 1) % 3]]), patch);
    }
  }
  deviation.mean =
    surface.triangles.empty() ? 0 : sum / (7.0 * static_cast<double>(surface.triangles.size()));
  return deviation;
}
} // namespace ransmesh

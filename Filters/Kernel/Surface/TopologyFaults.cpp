#include "Surface/TopologyFaults.h"

#include "Triangles/SurfaceEdges.h"
#include "Triangles/SurfaceRepair.h"

#include <numeric>

namespace ransmesh
{
namespace
{
Vector3 middleOf(const SurfaceMesh& surface, const SurfaceEdge& edge)
{
  return 0.5 * (surface.points[edge.a] + surface.points[edge.b]);
}

// Keeps the first finding of each triangle, in the order of the triangles.
void sortFindings(std::vector<SurfaceFinding>& findings)
{
  std::stable_sort(findings.begin(), findings.end(),
    [](const SurfaceFinding& f, const SurfaceFinding& g) { return f.triangle < g.triangle; });
  const auto same = [](const SurfaceFinding& f, const SurfaceFinding& g) { return f.triangle == g.triangle; };
  findings.erase(std::unique(findings.begin(), findings.end(), same), findings.end());
}

// Corner 3 t + i of triangle t is at edge.a or edge.b.
Index cornerAt(const SurfaceMesh& surface, Index t, Index v)
{
  const auto& corners = surface.triangles[t];
  return 3 * t + (corners[0] == v ? 0 : corners[1] == v ? 1 : 2);
}

// Joins the corners of triangles that share an edge at a point: what is left apart are the point's fans.
std::vector<Index> fansOfCorners(const SurfaceMesh& surface)
{
  std::vector<Index> parent(3 * surface.triangles.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](Index c)
  {
    while (parent[c] != c)
    {
      c = parent[c] = parent[parent[c]];
    }
    return c;
  };
  forEachEdge(sortedEdges(surface),
    [&](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      for (const SurfaceEdge* e = first + 1; e < last; ++e)
      {
        for (const Index v : { e->a, e->b })
        {
          parent[root(cornerAt(surface, e->triangle, v))] = root(cornerAt(surface, first->triangle, v));
        }
      }
    });
  for (std::size_t c = 0; c < parent.size(); ++c)
  {
    parent[c] = root(static_cast<Index>(c));
  }
  return parent;
}
} // namespace

Fault findDuplicates(const SurfaceMesh& surface)
{
  Fault fault;
  fault.kind = SurfaceFault::Duplicate;
  const std::vector<Index> first = firstOfEqual(surface);
  for (std::size_t t = 0; t < first.size(); ++t)
  {
    const auto triangle = static_cast<Index>(t);
    if (first[t] != triangle)
    {
      fault.where = fault.count++ == 0 ? centreOf(surface, triangle) : fault.where;
      fault.findings.push_back({ fault.kind, triangle, first[t] });
      fault.findings.push_back({ fault.kind, first[t], triangle });
    }
  }
  sortFindings(fault.findings);
  return fault;
}

Fault findOpenEdges(const SurfaceMesh& surface, const std::vector<AxisPlane>& closedBy)
{
  Fault fault;
  fault.kind = SurfaceFault::OpenEdge;
  forEachEdge(sortedEdges(surface),
    [&](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      if (last - first == 1 && !holdEdge(closedBy, surface.points[first->a], surface.points[first->b]))
      {
        fault.where = fault.count++ == 0 ? middleOf(surface, *first) : fault.where;
        fault.findings.push_back({ fault.kind, first->triangle, None });
      }
    });
  sortFindings(fault.findings);
  return fault;
}

Fault findNonManifoldEdges(const SurfaceMesh& surface)
{
  Fault fault;
  fault.kind = SurfaceFault::NonManifoldEdge;
  forEachEdge(sortedEdges(surface),
    [&](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      if (last - first <= 2)
      {
        return;
      }
      fault.where = fault.count++ == 0 ? middleOf(surface, *first) : fault.where;
      for (const SurfaceEdge* e = first; e < last; ++e)
      {
        const SurfaceEdge* next = e + 1 < last ? e + 1 : first;
        fault.findings.push_back({ fault.kind, e->triangle, next->triangle });
      }
    });
  sortFindings(fault.findings);
  return fault;
}

Fault findNonManifoldPoints(const SurfaceMesh& surface)
{
  Fault fault;
  fault.kind = SurfaceFault::NonManifoldPoint;
  const std::vector<Index> fan = fansOfCorners(surface);
  std::vector<Index> fanOfPoint(surface.points.size(), None);
  std::vector<char> isFaulty(surface.points.size(), 0);
  const auto corner = [&](std::size_t t, int i) { return fan[3 * t + i]; };
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Index v = surface.triangles[t][i];
      fanOfPoint[v] = fanOfPoint[v] == None ? corner(t, i) : fanOfPoint[v];
      if (fanOfPoint[v] != corner(t, i) && !isFaulty[v])
      {
        isFaulty[v] = 1;
        fault.where = fault.count++ == 0 ? surface.points[v] : fault.where;
      }
    }
  }
  for (std::size_t t = 0; t < surface.triangles.size() && fault.count > 0; ++t)
  {
    const auto& v = surface.triangles[t];
    if (isFaulty[v[0]] || isFaulty[v[1]] || isFaulty[v[2]])
    {
      fault.findings.push_back({ fault.kind, static_cast<Index>(t), None });
    }
  }
  return fault;
}

Fault findTurned(const SurfaceMesh& surface)
{
  Fault fault;
  fault.kind = SurfaceFault::Turned;
  forEachEdge(sortedEdges(surface),
    [&](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      if (last - first == 2 && first[0].forward == first[1].forward)
      {
        fault.where = fault.count++ == 0 ? middleOf(surface, *first) : fault.where;
      }
    });
  if (fault.count == 0)
  {
    return fault;
  }
  const std::vector<char> isTurned = turnedTriangles(surface);
  for (std::size_t t = 0; t < isTurned.size(); ++t)
  {
    if (isTurned[t])
    {
      fault.findings.push_back({ fault.kind, static_cast<Index>(t), None });
    }
  }
  return fault;
}
} // namespace ransmesh

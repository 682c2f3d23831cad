#include "PlaneFacet.h"

#include "Worker/RequestParts.h"

#include "Triangles/SurfaceEdges.h"

#include <algorithm>
#include <array>

namespace ransmesh
{
namespace
{
std::vector<Vector3> pointsOf(const worker::Request& request)
{
  std::vector<Vector3> points;
  points.reserve(request.points.size() / 3);
  for (std::size_t i = 0; i + 2 < request.points.size(); i += 3)
  {
    points.push_back({ request.points[i], request.points[i + 1], request.points[i + 2] });
  }
  return points;
}

// Edges far from the middle first. TetGen begins with the first points, and dies where a later one lies on the line of
// two with none beyond them.
void sortFromOutside(const std::vector<Vector3>& points, std::vector<std::array<Index, 2>>& edges)
{
  Vector3 middle;
  for (const auto& [a, b] : edges)
  {
    middle += (0.5 / static_cast<double>(edges.size())) * (points[a] + points[b]);
  }
  const auto reach = [&](const std::array<Index, 2>& edge)
  { return std::max(distance(points[edge[0]], middle), distance(points[edge[1]], middle)); };
  std::stable_sort(edges.begin(), edges.end(),
    [&](const auto& one, const auto& other) { return reach(one) > reach(other); });
}
} // namespace

PlaneEdges edgesIn(const SurfaceMesh& surface, const std::vector<char>& isSheet, const AxisPlane& plane)
{
  SurfaceMesh touching;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto& v = surface.triangles[t];
    const int inPlane = static_cast<int>(plane.holds(surface.points[v[0]])) +
      static_cast<int>(plane.holds(surface.points[v[1]])) +
      static_cast<int>(plane.holds(surface.points[v[2]]));
    if (inPlane >= 2)
    {
      touching.triangles.push_back(v);
      touching.patch.push_back(surface.patch[t]);
    }
  }
  PlaneEdges edges;
  forEachEdge(sortedEdges(touching),
    [&](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      if (!plane.holds(surface.points[first->a]) || !plane.holds(surface.points[first->b]))
      {
        return;
      }
      bool isBorder = false;
      for (const SurfaceEdge* edge = first; edge != last; ++edge)
      {
        isBorder = isBorder != !isSheet[touching.patch[edge->triangle]];
      }
      (isBorder ? edges.borders : edges.inside).push_back({ first->a, first->b });
    });
  return edges;
}

Outcome addPlaneFacet(const ClosingPlane& plane, PlaneEdges edges, const std::optional<PlaneOutline>& outline,
  worker::Request& request, PlaneArea& area)
{
  std::optional<Index> seed;
  if (outline)
  {
    seed = outline->seed;
    for (std::size_t i = 0; i < outline->loop.size(); ++i)
    {
      edges.outline.push_back({ outline->loop[i], outline->loop[(i + 1) % outline->loop.size()] });
    }
  }
  const std::vector<Vector3> points = pointsOf(request);
  if (Outcome outcome = findPlaneArea(points, plane.plane.axis, edges, seed, area); !outcome.ok())
  {
    return outcome;
  }
  sortFromOutside(points, area.edges);
  const auto polygon = static_cast<std::int32_t>(request.markers.size());
  for (std::size_t i = 0; i < area.edges.size(); ++i)
  {
    const auto& [a, b] = area.edges[i];
    if (i == 0)
    {
      addPolygon(request, { a, b }, plane.patch);
      continue;
    }
    request.segments.insert(request.segments.end(), { polygon, a, b });
  }
  for (const Vector3& hole : area.holes)
  {
    request.facetHoleOwners.push_back(polygon);
    request.facetHoles.insert(request.facetHoles.end(), { hole.x, hole.y, hole.z });
  }
  request.freeMarkers.push_back(plane.patch);
  return Outcome::done();
}
} // namespace ransmesh

#include "Surface/HoleFilling.h"

#include "Surface/Borders.h"
#include "Triangles/SurfaceEdges.h"
#include "Triangles/SurfaceRepair.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <map>

namespace ransmesh
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triple = CGAL::Triple<int, int, int>;

// The search through all triangulations of a border takes time with the cube of its points.
constexpr std::size_t LargestCubic = 300;

// New triangles run along the border against those that are there.
std::vector<Triple> triangulate(const SurfaceMesh& surface, const std::vector<Index>& border)
{
  std::vector<Kernel::Point_3> points;
  for (auto v = border.rbegin(); v != border.rend(); ++v)
  {
    const Vector3& p = surface.points[*v];
    points.emplace_back(p.x, p.y, p.z);
  }
  std::vector<Triple> triangles;
  CGAL::Polygon_mesh_processing::triangulate_hole_polyline(points, std::back_inserter(triangles),
    CGAL::parameters::use_2d_constrained_delaunay_triangulation(true).do_not_use_cubic_algorithm(
      points.size() > LargestCubic));
  return triangles;
}

int mostFrequentAround(
  const std::vector<Index>& border, const std::map<std::pair<Index, Index>, int>& patchAt)
{
  std::map<int, int> edges;
  for (std::size_t i = 0; i < border.size(); ++i)
  {
    const Index a = border[i];
    const Index b = border[(i + 1) % border.size()];
    ++edges[patchAt.at({ std::min(a, b), std::max(a, b) })];
  }
  const auto fewer = [](const auto& x, const auto& y) { return x.second < y.second; };
  return std::max_element(edges.begin(), edges.end(), fewer)->first;
}

std::map<std::pair<Index, Index>, int> patchAtOpenEdges(const SurfaceMesh& surface)
{
  std::map<std::pair<Index, Index>, int> patchAt;
  forEachEdge(sortedEdges(surface),
    [&](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      if (last - first == 1)
      {
        patchAt[{ first->a, first->b }] = surface.patch[first->triangle];
      }
    });
  return patchAt;
}

int addPatch(PatchTable& patches, std::size_t number)
{
  patches.push_back({ "hole_" + std::to_string(number), PatchType::Patch });
  return static_cast<int>(patches.size()) - 1;
}
} // namespace

FillReport fillHoles(
  SurfaceMesh& surface, PatchTable& patches, double largest, const std::vector<AxisPlane>& closedBy)
{
  FillReport report;
  const auto patchAt = patchAtOpenEdges(surface);
  for (const BorderLoop& loop : findBorders(surface))
  {
    const bool isLeft = holdEdge(closedBy, loop.extent.low, loop.extent.high);
    if (isLeft || !loop.isClosed || loop.points.size() < 3 || loop.extent.largestLength() > largest)
    {
      continue;
    }
    const std::vector<Triple> triangles = triangulate(surface, loop.points);
    if (triangles.empty())
    {
      continue;
    }
    const bool isSmall = loop.points.size() <= SmallHole;
    const int patch =
      isSmall ? mostFrequentAround(loop.points, patchAt) : addPatch(patches, ++report.newPatches);
    const auto corner = [&loop](int i) { return loop.points[loop.points.size() - 1 - i]; };
    for (const Triple& t : triangles)
    {
      surface.triangles.push_back({ corner(t.first), corner(t.second), corner(t.third) });
      surface.patch.push_back(patch);
    }
    report.where = report.holes++ == 0 ? surface.points[loop.points[0]] : report.where;
    report.triangles += triangles.size();
  }
  return report;
}
} // namespace ransmesh

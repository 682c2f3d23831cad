#include "Boundary/SurfaceCheck.h"

#include "Boundary/SurfaceEdges.h"
#include "Boundary/SurfaceIntersections.h"
#include "Boundary/SurfaceRepair.h"

#include <algorithm>
#include <cstdio>

namespace ransmesh
{
namespace
{
// Determinants of the fifth order in the coordinates must neither overflow nor vanish.
constexpr double LargestCoordinate = 1e50;
constexpr double SmallestExtent = 1e-50;

std::string counted(std::size_t n, const char* one, const char* many)
{
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

std::string coordinates(const Vector3& p)
{
  char text[96];
  std::snprintf(text, sizeof text, "(%.7g, %.7g, %.7g)", p.x, p.y, p.z);
  return text;
}

void mend(SurfaceMesh& surface, std::vector<std::string>& repairs)
{
  mergeEqualPoints(surface);
  if (const auto n = dropCollapsedTriangles(surface))
  {
    repairs.push_back(counted(n, "triangle", "triangles") + " with two equal corners dropped");
  }
  if (const auto n = swapFlatTriangles(surface))
  {
    repairs.push_back(
      counted(n, "flat triangle", "flat triangles") + " (three corners on a line) swapped with a neighbour");
  }
  if (const auto n = dropRepeatedTriangles(surface))
  {
    repairs.push_back(counted(n, "duplicate triangle", "duplicate triangles") + " dropped");
  }
  mergeEqualPoints(surface);
  if (const auto n = countTurnedTriangles(surface))
  {
    repairs.push_back(counted(n, "triangle runs", "triangles run") +
      " against the neighbours' orientation; the mesh's boundary is turned outward everywhere");
  }
}

bool findDegenerate(const SurfaceMesh& surface, const PatchTable& patches, SurfaceVerdict& verdict)
{
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (isDegenerate(surface, static_cast<Index>(t)))
    {
      verdict.findings.push_back({ SurfaceFault::Degenerate, static_cast<Index>(t), None });
    }
  }
  if (verdict.findings.empty())
  {
    return false;
  }
  verdict.outcome = Outcome::badInput("the surface has " +
    counted(verdict.findings.size(), "degenerate triangle", "degenerate triangles") +
    " (no area) that could not be mended, the first at " +
    placeOf(surface, verdict.findings[0].triangle, patches) + "; clean or remesh the surface there");
  return true;
}

bool findOpenEdges(const SurfaceMesh& surface, const PatchTable& patches,
  const std::vector<AxisPlane>& closedBy, SurfaceVerdict& verdict)
{
  const auto isClosed = [&](const SurfaceEdge& edge)
  {
    const auto holdsEdge = [&](const AxisPlane& plane)
    { return plane.holds(surface.points[edge.a]) && plane.holds(surface.points[edge.b]); };
    return std::any_of(closedBy.begin(), closedBy.end(), holdsEdge);
  };
  std::size_t open = 0;
  Vector3 where;
  forEachEdge(sortedEdges(surface),
    [&](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      if (last - first == 1 && !isClosed(*first))
      {
        if (open++ == 0)
        {
          where = 0.5 * (surface.points[first->a] + surface.points[first->b]);
        }
        verdict.findings.push_back({ SurfaceFault::OpenEdge, first->triangle, None });
      }
    });
  if (open == 0)
  {
    return false;
  }
  const int patch = surface.patch[verdict.findings[0].triangle];
  verdict.outcome =
    Outcome::badInput("the surface is not closed: " + counted(open, "open edge", "open edges") +
      ", the first at " + coordinates(where) + " in patch '" + patches[patch].name +
      "'; close the holes, or make the points along the gap coincide exactly");
  return true;
}

bool findCrossings(const SurfaceMesh& surface, const PatchTable& patches, SurfaceVerdict& verdict)
{
  const auto pairs = findIntersections(surface);
  if (pairs.empty())
  {
    return false;
  }
  for (const auto& [s, t] : pairs)
  {
    verdict.findings.push_back({ SurfaceFault::Intersection, s, t });
    verdict.findings.push_back({ SurfaceFault::Intersection, t, s });
  }
  verdict.outcome = Outcome::badInput("the surface intersects itself: " +
    counted(pairs.size(), "pair of triangles cuts or touches", "pairs of triangles cut or touch") +
    " each other, the first at " + placeOf(surface, pairs[0].first, patches) + " with patch '" +
    patches[surface.patch[pairs[0].second]].name + "'; separate the parts or unite them in the CAD system");
  return true;
}
} // namespace

std::string placeOf(const SurfaceMesh& surface, Index triangle, const PatchTable& patches)
{
  return coordinates(centreOf(surface, triangle)) + " in patch '" + patches[surface.patch[triangle]].name +
    "'";
}

Outcome checkCoordinates(const SurfaceMesh& surface, const char* what)
{
  for (std::size_t i = 0; i < surface.points.size(); ++i)
  {
    const Vector3& p = surface.points[i];
    const double largest = std::fmax(std::fabs(p.x), std::fmax(std::fabs(p.y), std::fabs(p.z)));
    if (!isFinite(p))
    {
      return Outcome::badInput("point " + std::to_string(i) + " of the " + what +
        " is not finite: " + coordinates(p) + "; repair the file or the filter that made it");
    }
    if (largest > LargestCoordinate)
    {
      return Outcome::badInput("point " + std::to_string(i) + " of the " + what + " lies at " +
        coordinates(p) + ", too far away to compute with (limit 1e50); check the units");
    }
  }
  return Outcome::done();
}

Outcome checkExtent(const SurfaceMesh& surface)
{
  if (surface.triangles.empty())
  {
    return Outcome::badInput("the input is empty: connect a surface of triangles or polygons");
  }
  if (Outcome outcome = checkCoordinates(surface, "surface"); !outcome.ok())
  {
    return outcome;
  }
  const Extent extent = extentOf(surface.points);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (extent.length(axis) < SmallestExtent)
    {
      return Outcome::badInput(std::string("the surface has no extent along ") + "xyz"[axis] +
        ": all its points have the coordinate " + std::to_string(extent.low[axis]) +
        "; a closed surface that encloses a volume is needed");
    }
  }
  return Outcome::done();
}

SurfaceVerdict mendAndCheck(
  SurfaceMesh& surface, const PatchTable& patches, const std::vector<AxisPlane>& closedBy)
{
  SurfaceVerdict verdict;
  verdict.outcome = checkExtent(surface);
  if (!verdict.outcome.ok())
  {
    return verdict;
  }
  mend(surface, verdict.repairs);
  if (surface.triangles.empty())
  {
    verdict.outcome = Outcome::badInput("all triangles of the surface are degenerate");
    return verdict;
  }
  findDegenerate(surface, patches, verdict) || findOpenEdges(surface, patches, closedBy, verdict) ||
    findCrossings(surface, patches, verdict);
  return verdict;
}
} // namespace ransmesh

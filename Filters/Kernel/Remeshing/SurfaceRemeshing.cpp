#include "Remeshing/SurfaceRemeshing.h"

#include "Remeshing/RemeshRounds.h"
#include "Triangles/NearTriangles.h"
#include "Triangles/SurfaceEdges.h"
#include "Triangles/SurfaceIntersections.h"
#include "Triangles/SurfaceRepair.h"
#include "Triangles/SurfaceTriangles.h"

#include <utility>

namespace ransmesh
{
namespace
{
// Where two sheets are nearer to each other than the surface may move, as by sharp edges between curved patches, they
// may cut each other afterwards, lie upon each other, or nearly touch: then it is remeshed again with a quarter of the
// deviation allowed.
constexpr int MostAttempts = 5;
constexpr double NearlyTouching = 1e-6; // of the largest extent

// Are there two triangles with a common edge that lie upon each other, but for rounding?
bool isFolded(const SurfaceMesh& surface)
{
  constexpr double upon = -1 + 1e-8; // 0.008 degrees
  bool found = false;
  forEachEdge(sortedEdges(surface),
    [&](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      const auto normal = [&surface](const SurfaceEdge* edge)
      { return normalized(areaVector(surface, surface.triangles[edge->triangle])); };
      found = found || (last - first == 2 && dot(normal(first), normal(first + 1)) < upon);
    });
  return found;
}

// Not told where there are triangles without area.
bool cutsItself(const SurfaceMesh& surface)
{
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (isDegenerate(surface, static_cast<Index>(t)))
    {
      return false;
    }
  }
  return isFolded(surface) || !findIntersections(surface, 1).empty();
}

bool nearlyTouchesItself(const SurfaceMesh& surface)
{
  const double distance = NearlyTouching * extentOf(surface.points).largestLength();
  return !findNearTriangles(surface, distance, 1).empty();
}

bool isWorse(const SurfaceMesh& made, const SurfaceMesh& given)
{
  return cutsItself(made) || (nearlyTouchesItself(made) && !nearlyTouchesItself(given));
}
} // namespace

Outcome remeshSurface(
  SurfaceMesh& surface, const RemeshingOptions& options, RemeshingReport& report, const Context& context)
{
  double strictness = 1;
  for (int attempt = 0; attempt < MostAttempts; ++attempt, strictness /= 4)
  {
    SurfaceMesh made;
    if (Outcome outcome = remeshInRounds(surface, options, strictness, context, made, report); !outcome.ok())
    {
      return outcome;
    }
    const bool isLast = attempt + 1 == MostAttempts;
    if (isLast || !isWorse(made, surface))
    {
      surface = std::move(made);
      break;
    }
  }
  return Outcome::done();
}
} // namespace ransmesh

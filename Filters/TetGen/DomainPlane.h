// Planes that bound a domain: symmetries, waterlines, the ground.
#pragma once

#include "Support/Outcome.h"
#include "Support/Patch.h"
#include "Triangles/PlaneCutting.h"
#include "Triangles/SurfaceMesh.h"

#include <string>
#include <vector>

namespace ransmesh
{
struct DomainPlane
{
  enum class Keep
  {
    Larger, // the side on which the surfaces reach farther; the side above if that is equal
    Below,
    Above
  };
  const char* purpose = ""; // for messages: "symmetry plane", ...
  AxisPlane plane;
  Keep keep = Keep::Larger;
  Patch patch; // the name and type of the plane's patch
  // The surface's own patch that lies in the plane, all of it, and goes with the cut; None if there is not just one.
  int ownPatch = None;
};

// What a half model's open edges may be off the plane, times the largest extent of the surfaces.
inline constexpr double PlaneTolerance = 1e-6;

// Cuts the surfaces by the planes: what lies beyond them, or in them, goes. Says in each plane which side is kept.
// Points of equal coordinates become one. BadInput where two planes lie across one axis, or nothing is left.
Outcome cutByPlanes(SurfaceMesh& surface, std::vector<DomainPlane>& planes);

// BadInput where a plane holds no point of the surface, so that it cannot close it.
Outcome checkReach(const SurfaceMesh& surface, const std::vector<DomainPlane>& planes);

// Puts points within PlaneTolerance of a plane on it.
void snapToPlanes(SurfaceMesh& surface, const std::vector<DomainPlane>& planes);

std::vector<AxisPlane> axisPlanes(const std::vector<DomainPlane>& planes);

// A plane that closes the domain, with the number of its patch.
struct ClosingPlane
{
  AxisPlane plane;
  int patch = 0;
};
} // namespace ransmesh

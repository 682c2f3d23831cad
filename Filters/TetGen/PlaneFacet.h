// A plane that closes a domain, in the terms of the program that runs TetGen.
#pragma once

#include "DomainPlane.h"
#include "Worker/Protocol.h"

#include "Domain/PlaneArea.h"

#include <optional>

namespace ransmesh
{
// What a box's side adds to the plane that it lies in.
struct PlaneOutline
{
  std::vector<int> loop; // points of the request, around the side
  int seed = 0;          // one of them, which no body reaches
};

// The surface's edges in the plane: where an odd number of closed surfaces' triangles meet at one, it is a border.
PlaneEdges edgesIn(const SurfaceMesh& surface, const std::vector<char>& isSheet, const AxisPlane& plane);

// Adds a polygon for the part of the plane that bounds the fluid: within the edges that are borders, or between them
// and the outline. It may be divided; all its edges but those that the request sets free are to be kept. `area` gets
// the part's edges. BadInput where the edges do not bound an area.
Outcome addPlaneFacet(const ClosingPlane& plane, PlaneEdges edges, const std::optional<PlaneOutline>& outline,
  worker::Request& request, PlaneArea& area);
} // namespace ransmesh

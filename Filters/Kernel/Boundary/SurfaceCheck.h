// Whether a surface can bound a mesh, and if not, what is wrong with it and where.
#pragma once

#include "Boundary/Patch.h"
#include "Boundary/PlaneCutting.h"
#include "Boundary/SurfaceMesh.h"
#include "Support/Outcome.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace ransmesh
{
enum class SurfaceFault
{
  Degenerate,   // a triangle without area
  OpenEdge,     // an edge of one triangle only: a hole in the surface
  Intersection, // triangles that cut or touch each other
  InsideFluid   // a sheet with fluid on both sides
};
inline constexpr std::array<std::string_view, 4> SurfaceFaultNames = { "degenerate triangle", "open edge",
  "intersection", "sheet inside the fluid" };

struct SurfaceFinding
{
  SurfaceFault fault = SurfaceFault::Degenerate;
  Index triangle = None;
  Index partner = None; // the other triangle of a pair
};

struct SurfaceVerdict
{
  Outcome outcome;                      // BadInput: the text says what, where, and the remedy
  std::vector<SurfaceFinding> findings; // the triangles that are wrong
  std::vector<std::string> repairs;     // what was mended, one sentence each
};

// Whether all coordinates are finite and of sane size. what: "surface" or "sheet", for the text.
Outcome checkCoordinates(const SurfaceMesh& surface, const char* what);

// Whether the surface has triangles, finite coordinates of sane size, and an extent along each axis.
// To be asked before anything else is done with the coordinates.
Outcome checkExtent(const SurfaceMesh& surface);

// Mends what is harmless (points of equal coordinates, collapsed, flat or repeated triangles), then
// looks for open edges and intersections, in exact arithmetic. In the planes `closedBy` edges may be open: the
// planes close the surface there.
SurfaceVerdict mendAndCheck(
  SurfaceMesh& surface, const PatchTable& patches, const std::vector<AxisPlane>& closedBy = {});

// "(x, y, z) in patch 'name'" of a triangle's centre.
std::string placeOf(const SurfaceMesh& surface, Index triangle, const PatchTable& patches);
} // namespace ransmesh

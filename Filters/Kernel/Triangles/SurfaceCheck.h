// Whether a surface can bound a mesh, and if not, what is wrong with it and where.
#pragma once

#include "Support/Outcome.h"
#include "Support/Patch.h"
#include "Triangles/SurfaceMesh.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace ransmesh
{
enum class SurfaceFault
{
  NotFinite,        // a corner is no number, or too far away to compute with
  Degenerate,       // a triangle without area
  Duplicate,        // a triangle with the points of another
  OpenEdge,         // an edge of one triangle only: a hole in the surface
  NonManifoldEdge,  // an edge of more than two triangles
  NonManifoldPoint, // a point where fans of triangles meet that share no edge there
  Turned,           // a triangle that runs against its neighbours
  Intersection,     // triangles that cut or touch each other
  NearSheets,       // triangles that nearly touch each other
  InsideFluid       // a sheet with fluid on both sides
};
inline constexpr std::array<std::string_view, 10> SurfaceFaultNames = { "coordinates not finite",
  "degenerate triangle", "duplicate triangle", "open edge", "non-manifold edge", "non-manifold point",
  "turned triangle", "intersection", "nearly coincident sheets", "sheet inside the fluid" };

// Whether a surface with such a fault cannot bound a mesh.
inline bool preventsMeshing(SurfaceFault fault)
{
  return fault == SurfaceFault::NotFinite || fault == SurfaceFault::Degenerate ||
    fault == SurfaceFault::Duplicate || fault == SurfaceFault::OpenEdge ||
    fault == SurfaceFault::Intersection || fault == SurfaceFault::InsideFluid;
}

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

// Whether a point can be computed with: finite, and not beyond 1e50.
bool isUsable(const Vector3& p);

// "(x, y, z)"
std::string placeOf(const Vector3& p);

// "(x, y, z) in patch 'name'" of a triangle's centre.
std::string placeOf(const SurfaceMesh& surface, Index triangle, const PatchTable& patches);
} // namespace ransmesh

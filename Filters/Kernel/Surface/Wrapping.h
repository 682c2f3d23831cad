// A closed surface around parts that are open, doubled or cross.
#pragma once

#include "Support/Context.h"
#include "Support/Outcome.h"
#include "Triangles/SurfaceMesh.h"

namespace ransmesh
{
// Lengths in the surface's unit.
struct WrapOptions
{
  double alpha = 0;  // what is narrower than this is bridged; also the size of the new triangles. Above 0
  double offset = 0; // how far outside the given surface the wrap lies. 0: alpha / 30
};

struct WrapReport
{
  double alpha = 0;
  double offset = 0;
  std::size_t triangles = 0;
};

// Replaces the surface by a wrap from outside (Portaneri et al., Alpha wrapping with an offset, SIGGRAPH 2022, by
// CGAL): closed, oriented outward, without crossings, at the distance of the offset. Each new triangle
// belongs to the patch of the given triangle that is nearest to its centre. Holes narrower than alpha are closed;
// what lies inside is not kept. BadInput if the options are out of range or ask for too many triangles.
Outcome wrapSurface(
  SurfaceMesh& surface, const WrapOptions& options, const Context& context, WrapReport& report);

// A size of details that keeps a wrap's cost within bounds: a hundredth of the extent.
double proposedAlpha(const SurfaceMesh& surface);
} // namespace ransmesh

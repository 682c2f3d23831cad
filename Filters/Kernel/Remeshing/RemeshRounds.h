// One attempt to remesh a surface.
#pragma once

#include "Remeshing/SurfaceRemeshing.h"

namespace ransmesh
{
// Remeshes in rounds of splits, collapses, swaps and movement. strictness: how much of the deviation allowed is made
// use of, above 0 and at most 1. Whether the surface made cuts itself is to be checked. BadInput where it would have
// more than 20 million triangles.
Outcome remeshInRounds(const SurfaceMesh& given, const RemeshingOptions& options, double strictness,
  const Context& context, SurfaceMesh& made, RemeshingReport& report);
} // namespace ransmesh

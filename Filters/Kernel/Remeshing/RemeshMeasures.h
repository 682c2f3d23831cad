// How good a remeshed surface is, and how near to the one that was given.
#pragma once

#include "Remeshing/SurfaceReference.h"
#include "Remeshing/SurfaceRemeshing.h"

namespace ransmesh
{
// featureAngle (degrees): where the surface made turns by more, its edges are lines.
RemeshingReport measureRemeshing(const SurfaceReference& given, const SurfaceMesh& made, double featureAngle);
} // namespace ransmesh

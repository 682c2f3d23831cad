// A domain in the terms of the program that runs TetGen.
#pragma once

#include "FarField.h"
#include "Worker/Protocol.h"
#include "Worker/SizeLimits.h"

#include <optional>

namespace ransmesh
{
// The surface, with its sheets, and the box around it, if there is one. Where points and edges of sheets lie
// exactly on the box, its sides get them too. The box's sides may be divided, all else is to be kept.
worker::Request describeDomain(const SurfaceMesh& surface, const std::optional<FarFieldBox>& box);

// Adds the sizes: those of the surface's own edges, and those that are asked for in space.
void describeSizes(const SurfaceMesh& surface, const SizeLimits& limits, worker::Request& request);
} // namespace ransmesh

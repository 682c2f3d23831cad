// A domain in the terms of the program that runs TetGen.
#pragma once

#include "Domain.h"
#include "Worker/Protocol.h"
#include "Worker/SizeLimits.h"

#include "Support/Outcome.h"

namespace ransmesh
{
// The surface, with its sheets, the box around it, if there is one, and the planes that close it. Where points and
// edges of the surface lie exactly on the box, its sides get them too. The box's sides and the planes may be
// divided, all else is to be kept. BadInput where planes do not close the surface.
Outcome describeDomain(const Domain& domain, worker::Request& request);

// Adds the sizes: those of the surface's own edges, and those that are asked for in space.
void describeSizes(const SurfaceMesh& surface, const SizeLimits& limits, worker::Request& request);
} // namespace ransmesh

// The box around bodies, in the terms of the program that runs TetGen.
#pragma once

#include "Domain.h"
#include "Worker/Protocol.h"

#include "Support/Outcome.h"

namespace ransmesh
{
// Adds the sides of the domain's box to a request that has the surface's points, with what of the surface lies on
// them. Sides that planes of the domain are get holes where the surface is open. BadInput where it cannot be said
// which part of a plane lies in the fluid.
Outcome addBox(const Domain& domain, worker::Request& request);
} // namespace ransmesh

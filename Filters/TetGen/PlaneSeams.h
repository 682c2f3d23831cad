// The edges along which two planes close a domain together.
#pragma once

#include "Domain.h"
#include "Worker/Protocol.h"

#include <array>
#include <vector>

namespace ransmesh
{
using PlaneSeam = std::vector<std::array<Index, 2>>;

// For each plane of a domain without a box: the parts of the lines where it meets other planes that bound the
// fluid, between points of the surface there, and, where three planes meet in the fluid, a new point of the request.
// The seams may be divided.
std::vector<PlaneSeam> addSeams(const Domain& domain, worker::Request& request);
} // namespace ransmesh

// Points that stand on the same place.
#pragma once

#include "Geometry/Vector3.h"

#include <cstdint>
#include <vector>

namespace ransmesh
{
// The numbers, ascending, of the points that have exactly the coordinates of one with a smaller number.
// Points must be finite. Time is linear in their count.
std::vector<std::int32_t> findCoincident(const std::vector<Vector3>& points);
} // namespace ransmesh

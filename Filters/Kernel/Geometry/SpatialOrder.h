// Orders in which neighbours in space come soon after each other, so that memory is still at hand.
#pragma once

#include "Geometry/Vector3.h"

#include <cstdint>
#include <vector>

namespace ransmesh
{
// Sorts numbers of points along a Morton curve through the box that holds them; equal codes by number.
// Points must be finite. Deterministic.
void sortSpatially(const std::vector<Vector3>& points, std::vector<std::int32_t>& numbers);
} // namespace ransmesh

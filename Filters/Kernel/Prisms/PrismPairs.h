// Which prisms are halves of hexahedra.
#pragma once

#include "Prisms/JoinedGroups.h"

namespace ransmesh
{
using PrismPair = std::array<Index, 2>;

// The pairs of prisms that follow one another from a side on, up to where it is closed: each is to become a
// hexahedron. Nothing if the side is never closed, or a hexahedron would not be sound.
std::optional<std::vector<PrismPair>> pairsFrom(const JoinedGroups& groups, GroupSide side);
} // namespace ransmesh

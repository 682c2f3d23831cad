// Which groups of one and two tetrahedra are halves of a prism.
#pragma once

#include "Prisms/JoinedGroups.h"

namespace ransmesh
{
struct PrismHalves
{
  double size; // the perimeters of the prism's triangles
  Index one;   // the group of one tetrahedron
  Index two;   // the group of two
};

// All pairs that would make a prism, the smallest first: below fans the tetrahedron of one half makes a prism with the
// wrong other one, too, which is askew.
std::vector<PrismHalves> findHalves(const JoinedGroups& groups);
} // namespace ransmesh

// What an operation may do to the boundary.
#pragma once

#include "Boundary/Classification.h"

#include <algorithm>
#include <vector>

namespace ransmesh
{
// Which boundary faces may be starred again, and what stands on the boundary.
struct BoundaryRules
{
  Classification classification;
  std::vector<char> changeable; // by patch number

  // May a face of this patch be starred from the apex? Only if the apex lies on the patch.
  bool mayStar(int patch, Index apex) const
  {
    const auto own = classification.patchesAt(apex);
    return changeable[patch] && std::find(own.begin(), own.end(), patch) != own.end();
  }
};
} // namespace ransmesh

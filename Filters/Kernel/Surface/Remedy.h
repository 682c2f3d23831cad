// What a user can do about an unsound surface.
#pragma once

#include "Surface/Diagnosis.h"

#include <string>

namespace ransmesh
{
// The remedy as a sentence without its end: repairs with the values that were tried out on a copy, else wrapping, or
// what is to be done by hand. In the planes of `closedBy` edges may be open.
std::string proposeRemedy(const SurfaceMesh& surface, const PatchTable& patches, const Diagnosis& diagnosis,
  const std::vector<AxisPlane>& closedBy = {});
} // namespace ransmesh

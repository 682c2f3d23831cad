// A box around bodies.
#pragma once

#include "Boundary/Patch.h"
#include "Boundary/SurfaceMesh.h"

#include <array>

namespace ransmesh
{
struct FarFieldBox
{
  std::array<Vector3, 8> corners;          // corner i: bit 0 high x, bit 1 high y, bit 2 high z
  std::array<std::array<int, 4>, 6> sides; // corners of xmin, xmax, ymin, ymax, zmin, zmax
  std::array<int, 6> patches;              // the patch number of each side
};

// margins: distances from the bodies' extent to the sides, in body lengths (the largest extent), in the
// order of the sides. Adds the sides to the table as farfield_xmin, ... of type farfield.
FarFieldBox makeFarField(const Extent& bodies, const std::array<double, 6>& margins, PatchTable& patches);
} // namespace ransmesh

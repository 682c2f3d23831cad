// Random closed surfaces: unions of boxes, prisms and spheres, cut by planes, turned and scaled.
#pragma once

#include "Bodies/Body.h"

#include <cstdint>

namespace bodies
{
struct RandomBody
{
  Body body;
  double size = 0;  // edge length of its triangles
  double scale = 1; // its extent is about this, 1e-3 to 1e6
};

// The same seed gives the same body. Its patches, all walls, are split where the surface turns by more than
// 30 degrees, on every other seed. The surface may be faulty where parts nearly touch: then it has no triangles.
RandomBody randomBody(std::uint32_t seed);
} // namespace bodies

// A tetrahedral mesh as plain arrays: what goes into the kernel and what comes out of it.
#pragma once

#include "Geometry/Vector3.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ransmesh
{
using Index = std::int32_t;
inline constexpr Index None = -1;

struct MeshData
{
  std::vector<Vector3> points;
  std::vector<std::array<Index, 4>> tetrahedra; // positive: orientation(v0, v1, v2, v3) > 0
  std::vector<std::array<Index, 3>> triangles;  // the boundary, turned outward, away from the fluid; sheets
  std::vector<int> trianglePatch;               // patch number (>= 1) of each triangle
  // Cut open along its sheets (Boundary/Sheets.h): points may coincide there, and no triangle lies inside.
  bool isOpened = false;
};
} // namespace ransmesh

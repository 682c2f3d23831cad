// What a pass of the removal may do to the mesh.
#pragma once

#include <cstddef>

namespace ransmesh
{
struct RemovalLimits
{
  double quality = 0.15;  // no new tetrahedron may be worse
  std::size_t growth = 0; // by how many tetrahedra a cavity may grow
  int cuts = 0;           // how many edges may be taken from the point first
  double keep = 0;        // where the ones that go are worse, this share of their worst is enough
  double wallAngle = 120; // the largest angle of a wall's triangles, degrees, or what they have already
};
} // namespace ransmesh

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
  bool orNoWorse = false; // where the ones that go are worse, no worse than these is enough
};
} // namespace ransmesh

// A triangulated surface with a patch number on each triangle: what bounds a domain before it is meshed.
#pragma once

#include "Geometry/Extent.h"
#include "Mesh/MeshData.h"

#include <array>
#include <vector>

namespace ransmesh
{
struct SurfaceMesh
{
  std::vector<Vector3> points;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<int> patch; // patch number (>= 1) of each triangle
};

inline Vector3 centreOf(const SurfaceMesh& surface, Index triangle)
{
  const auto& v = surface.triangles[triangle];
  return (1.0 / 3) * (surface.points[v[0]] + surface.points[v[1]] + surface.points[v[2]]);
}
} // namespace ransmesh

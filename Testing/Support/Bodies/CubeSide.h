// Sides of a cube, for small closed surfaces.
#pragma once

#include "Triangles/SurfaceMesh.h"

#include <array>

namespace bodies
{
// Adds the side of the cube [-1, 1]^3 that is low or high along an axis: n^2 squares, each cut in two, turned
// outward, of one patch. Its border has points of its own.
inline void addCubeSide(int axis, bool high, int n, int patch, ransmesh::SurfaceMesh& surface)
{
  using ransmesh::Index;
  const auto first = static_cast<Index>(surface.points.size());
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      ransmesh::Vector3 p;
      p[axis] = high ? 1 : -1;
      p[(axis + 1) % 3] = 2.0 * i / n - 1;
      p[(axis + 2) % 3] = 2.0 * j / n - 1;
      surface.points.push_back(p);
    }
  }
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const Index a = first + i * (n + 1) + j;
      const Index b = a + n + 1;
      surface.triangles.push_back(high ? std::array{ a, b, b + 1 } : std::array{ a, b + 1, b });
      surface.triangles.push_back(high ? std::array{ a, b + 1, a + 1 } : std::array{ a, a + 1, b + 1 });
    }
  }
  surface.patch.resize(surface.triangles.size(), patch);
}
} // namespace bodies

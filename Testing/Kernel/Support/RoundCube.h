// Small closed surfaces for the tests of their check and repair.
#pragma once

#include "Support/Patch.h"
#include "Triangles/SurfaceMesh.h"
#include "Triangles/SurfaceRepair.h"

#include "Bodies/CubeSide.h"

#include <string>

namespace ransmesh::test
{
// The cube [-1, 1]^3, each side a patch (1 to 6) of 2 n^2 triangles, turned outward.
inline SurfaceMesh cube(int n)
{
  SurfaceMesh s;
  for (int side = 0; side < 6; ++side)
  {
    bodies::addCubeSide(side / 2, side % 2 != 0, n, side + 1, s);
  }
  mergeEqualPoints(s);
  return s;
}

inline SurfaceMesh ball(int n)
{
  SurfaceMesh s = cube(n);
  for (Vector3& p : s.points)
  {
    p = (1 / norm(p)) * p;
  }
  return s;
}

inline SurfaceMesh moved(SurfaceMesh s, const Vector3& by, double scale = 1)
{
  for (Vector3& p : s.points)
  {
    p = scale * p + by;
  }
  return s;
}

inline void append(SurfaceMesh& s, const SurfaceMesh& other)
{
  const auto offset = static_cast<Index>(s.points.size());
  s.points.insert(s.points.end(), other.points.begin(), other.points.end());
  s.patch.insert(s.patch.end(), other.patch.begin(), other.patch.end());
  for (const auto& t : other.triangles)
  {
    s.triangles.push_back({ t[0] + offset, t[1] + offset, t[2] + offset });
  }
}

inline PatchTable sixPatches()
{
  PatchTable patches = { { "fluid", PatchType::Patch } };
  for (int i = 1; i <= 6; ++i)
  {
    patches.push_back({ "side" + std::to_string(i), PatchType::Wall });
  }
  return patches;
}
} // namespace ransmesh::test

// Cuts surfaces by planes across an axis.
#pragma once

#include "Triangles/SurfaceMesh.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ransmesh
{
struct AxisPlane
{
  int axis = 0; // 0, 1, 2: the plane lies across x, y, z
  double place = 0;
  bool keepsAbove = true; // of what is cut, the part with the larger coordinates stays

  bool holds(const Vector3& p) const { return p[axis] == place; }
};

// Whether an edge lies in one of the planes.
inline bool holdEdge(const std::vector<AxisPlane>& planes, const Vector3& a, const Vector3& b)
{
  return std::any_of(
    planes.begin(), planes.end(), [&](const AxisPlane& plane) { return plane.holds(a) && plane.holds(b); });
}

// What reaches beyond the plane goes, and with it triangles that lie in the plane; the new border lies exactly in
// it. Points within tolerance of the plane are put on it; so are those that are near to it for the length of an
// edge that passes through it, along that edge, so that no triangle becomes much thinner. Edges where the surface
// ends, changes its patch, or turns by more than ridgeAngle (degrees), keep their line. Points of equal
// coordinates must be one point; points that are not used any more remain. Gives the number of triangles of
// which something went.
std::size_t cutByPlane(
  SurfaceMesh& surface, const AxisPlane& plane, double tolerance, double ridgeAngle = 180);
} // namespace ransmesh

// The normal of a plane patch.
#ifndef PlaneNormal_h
#define PlaneNormal_h

#include "MeshView.h"

#include <optional>

namespace ransmesh
{
// The mean of the faces' unit normals, if no face's normal is further from it than `tolerance` (no unit); nothing
// if the patch is not plane.
std::optional<std::array<double, 3>> planeNormal(
  const MeshView& mesh, const BoundaryPatch& patch, double tolerance);
} // namespace ransmesh

#endif

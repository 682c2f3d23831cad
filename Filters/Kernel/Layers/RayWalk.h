// Follows rays from vertices through the mesh.
#pragma once

#include "Mesh/Traversal.h"

namespace ransmesh
{
class RayWalk
{
public:
  explicit RayWalk(const TetMesh& mesh)
    : mesh_(mesh)
    , traversal_(mesh)
  {
  }

  // The distance along the unit vector d at which the ray from v leaves the mesh, or reach if it is
  // still inside there. A ray that cannot be followed counts as free. Rays along edges or faces of the
  // mesh may be lost: let them lean a little.
  double freeDistance(Index v, const Vector3& d, double reach);
  // The patch at which the last ray left the mesh; 0 if it did not.
  int patchHit() const { return patchHit_; }

private:
  bool passes(const std::array<Index, 3>& face, const Vector3& from, const Vector3& d) const;
  HalfFace firstExit(Index v, const Vector3& d);
  HalfFace exitFrom(HalfFace entry, const Vector3& from, const Vector3& d) const;
  double distanceTo(HalfFace h, const Vector3& from, const Vector3& d) const;

  const TetMesh& mesh_;
  Traversal traversal_;
  int patchHit_ = 0;
};
} // namespace ransmesh

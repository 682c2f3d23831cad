// What a change of a surface's triangles may do to its shape: verdicts before the deed.
#pragma once

#include "Remeshing/EditableSurface.h"
#include "Remeshing/SurfaceReference.h"

namespace ransmesh
{
// As a part of the wanted edge, how far a new triangle may lie from the given surface. An edge of a tenth of
// a circle lies this far from it.
inline constexpr double DeviationShare = 0.05;
// A new triangle's normal is within this angle of the given surface's, in degrees.
inline constexpr double TurnOfTriangle = 30;

// A verdict allows what keeps the surface within a tolerance (a length), its normals within TurnOfTriangle, and
// makes no triangle with an angle below 5 degrees: unless it was worse before.
class RemeshGuard
{
public:
  // Both must live as long as this.
  RemeshGuard(EditableSurface& surface, const SurfaceReference& reference);

  bool allowsCollapse(Index gone, Index kept, double tolerance) const;
  bool allowsSwap(Index a, Index b, const std::array<Corners, 2>& made, double tolerance) const;
  // Whether the smallest angle of the triangles around becomes greater.
  bool collapseBetters(Index gone, Index kept) const;
  // Moves a point if the triangles around it stay near the surface, and good or as good as they are.
  void moveIfBetter(Index v, const Vector3& place, double tolerance);

private:
  double leastAngleAround(Index v) const;
  bool follows(const Corners& made, int patch, double least) const;
  double following(const Corners& corners, int patch) const;
  double offPatch(const Vector3& a, const Vector3& b, int patch) const;
  double offLine(const Vector3& a, const Vector3& b, Index line) const;
  bool lineAllows(Index gone, Index kept, double tolerance) const;
  double farthestOfEdges(Index v) const;

  EditableSurface& surface_;
  const SurfaceReference& reference_;
};
} // namespace ransmesh

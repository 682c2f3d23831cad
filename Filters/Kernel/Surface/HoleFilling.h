// Holes of a surface, closed.
#pragma once

#include "Support/Patch.h"
#include "Triangles/PlaneCutting.h"
#include "Triangles/SurfaceMesh.h"

namespace ransmesh
{
struct FillReport
{
  std::size_t holes = 0;
  std::size_t triangles = 0;
  std::size_t newPatches = 0;
  Vector3 where; // the first
};

// A hole with more edges than this is closed by a patch of its own, hole_1, hole_2, ... of type `patch`.
inline constexpr std::size_t SmallHole = 12;

// Closes the holes whose border has an extent of at most `largest` (in the surface's unit), by triangles
// between the border's own points (CGAL's minimal triangulation: smallest dihedral angles, then areas). Those of a
// small hole belong to the patch that is most frequent around it. Triangles must be oriented alike.
// Borders in the planes `closedBy` are left open.
FillReport fillHoles(
  SurfaceMesh& surface, PatchTable& patches, double largest, const std::vector<AxisPlane>& closedBy);
} // namespace ransmesh

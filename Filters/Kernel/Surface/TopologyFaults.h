// What is wrong with how the triangles of a surface hang together.
#pragma once

#include "Surface/Diagnosis.h"

namespace ransmesh
{
// Each gives a fault with count 0 where there is none. Points of equal coordinates must be one point, and no
// triangle name a point twice.

// Triangles with the points of one before.
Fault findDuplicates(const SurfaceMesh& surface);
// Edges of one triangle, but those in the planes that close the surface.
Fault findOpenEdges(const SurfaceMesh& surface, const std::vector<AxisPlane>& closedBy);
// Edges of more than two triangles.
Fault findNonManifoldEdges(const SurfaceMesh& surface);
// Points where fans of triangles meet that share no edge there.
Fault findNonManifoldPoints(const SurfaceMesh& surface);
// Edges of two triangles that run along them in the same direction; the findings are the triangles that would
// have to be turned, the fewer of each piece.
Fault findTurned(const SurfaceMesh& surface);
} // namespace ransmesh

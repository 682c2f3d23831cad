// A new triangulation of a surface, with triangles of one size.
#pragma once

#include "Boundary/SurfaceMesh.h"
#include "Support/Outcome.h"

namespace ransmesh
{
// Replaces the triangles by nearly equilateral ones with edges of about `length`, by isotropic remeshing
// (M. Botsch, L. Kobbelt, SGP 2004, as in CGAL). New points lie on the old surface. Edges where the
// surface turns by more than `angle` degrees, and the borders between patches, are kept as lines; their
// corners are kept as points. The surface must be closed and free of intersections; whether it still is
// afterwards is to be checked, since features smaller than `length` can collapse. BadInput, with the
// surface unchanged, where more than two triangles meet at an edge.
Outcome remeshSurface(SurfaceMesh& surface, double length, double angle);
} // namespace ransmesh

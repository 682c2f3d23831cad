// Harmless faults of a surface that can be mended without changing its shape.
#pragma once

#include "Triangles/SurfaceMesh.h"

#include <cstddef>
#include <vector>

namespace ransmesh
{
// Makes points of equal coordinates one point, and drops points that no triangle uses. Points keep the
// order of their first use by coordinates. The coordinates must be finite.
void mergeEqualPoints(SurfaceMesh& surface);

// Triangles without area: two corners are one point, or all three lie exactly on a line.
bool isDegenerate(const SurfaceMesh& surface, Index triangle);

// Drops triangles that name a point twice. Gives how many.
std::size_t dropCollapsedTriangles(SurfaceMesh& surface);

// Keeps the triangles whose flag is set. Gives how many went.
std::size_t keepTriangles(SurfaceMesh& surface, const std::vector<char>& stays);

// For each triangle the first one with the same three points, in any order.
std::vector<Index> firstOfEqual(const SurfaceMesh& surface);

// Drops all but the first of triangles with the same three points. Gives how many.
std::size_t dropRepeatedTriangles(SurfaceMesh& surface);

// A triangle whose corners lie on a line is mended by swapping its longest side with the neighbour
// there, which takes its place: the surface covers the same points of space. Gives how many were mended.
std::size_t swapFlatTriangles(SurfaceMesh& surface);

// A flag a triangle: whether it runs against its neighbours. Of what hangs together by edges of two triangles
// it is the smaller part.
std::vector<char> turnedTriangles(const SurfaceMesh& surface);
} // namespace ransmesh

// Surfaces of very obtuse triangles, as CAD systems make them, get better ones of the same shape.
#pragma once

#include "Remeshing/SurfaceSwaps.h"

namespace ransmesh
{
struct FlatTriangleReport
{
  std::size_t swaps = 0;
  std::size_t splits = 0;   // points added
  double largestShift = 0;  // how far a swapped side lies from the one that it replaces, at most
  double largestBefore = 0; // largest angle of a triangle, degrees
  double largestAfter = 0;
  std::size_t flatBefore = 0; // triangles with an angle above FlatTriangleAngle
  std::size_t flatAfter = 0;
  bool isRefused = false; // no swaps: with them the surface would cut itself
};

// Triangles above this angle, in degrees, are split where no swap betters them. It is wider than
// FlatTriangleAngle, since the short edges that splits make cost layers in corners: splits from 175 degrees on
// cost a finned missile, whose triangles had 175.5, one column point in a hundred.
inline constexpr double SplitTriangleAngle = 177;

// The new edge from foot to corner must be at least this part of the surface's largest extent: on a wing of
// needles of a millionth of its chord, TetGen could not tell shorter ones apart.
inline constexpr double ShortestSplit = 2e-5;

// Swaps diagonals (swapDiagonals). What is still above SplitTriangleAngle then is obtuse against a ridge or the
// border of a patch: there the longest side is split at the foot of the opposite corner, in all triangles
// that meet at it, and diagonals are swapped again, a few times. New points lie on sides, but for rounding, so
// splits do not change the shape; without maySplit there are none. Sides between two points with `keep` (a
// flag a point, or none) stay.
FlatTriangleReport mendFlatTriangles(
  SurfaceMesh& surface, double angle, std::vector<char> keep = {}, bool maySplit = true);

// The splits alone, each triangle taking part in one at most. Gives how many points were added at the end.
std::size_t splitFlatTriangles(SurfaceMesh& surface, const std::vector<char>& keep);
} // namespace ransmesh

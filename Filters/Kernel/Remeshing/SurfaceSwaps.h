// Better triangles of the same points: diagonals are swapped within patches.
#pragma once

#include "Triangles/SurfaceMesh.h"

#include <cstddef>
#include <vector>

namespace ransmesh
{
struct SwapReport
{
  std::size_t swaps = 0;
  double largestShift = 0;  // how far a side lies from the one that it replaces, at most; length unit
  double largestBefore = 0; // largest angle of a triangle, degrees
  double largestAfter = 0;
  std::size_t flatBefore = 0; // triangles with an angle above FlatTriangleAngle
  std::size_t flatAfter = 0;
  bool isRefused = false; // the surface stays as it was: with swaps it would cut itself
};
inline constexpr double FlatTriangleAngle = 175; // degrees

// Triangles with smaller angles are left as they are (degrees), so that good surfaces keep theirs.
inline constexpr double ObtuseTriangleAngle = 150;

// The height below which a triangle is taken for a line without a normal of its own, as a part of the
// surface's largest extent: what rounding in single precision does to coordinates.
inline constexpr double LineHeight = 2e-7;

// Swaps the diagonal of two triangles of one patch where that lowers the largest of their angles, the worst
// triangle first, until no swap is left (C. L. Lawson, in Mathematical Software III, 1977, with the min-max
// angle of H. Edelsbrunner, T. S. Tan, R. Waupotitsch, SIAM J. Sci. Stat. Comput. 13, 1992). No point moves
// or goes, and the borders of patches stay. No swap folds the surface, or makes an edge that is there already.
// None turns it: both new triangles lie within `angle` degrees (0 to 90) of both old ones, so that ridges of
// more than twice the angle stay, and at each corner of one that the surface had there at the beginning, so
// that turns do not add up. Triangles lower than LineHeight have no normal of their own and go where their
// neighbours are.
// Edges between two points with `keep` (a flag a point, or none) stay, as do those where not exactly two
// triangles meet, turned alike. Where the surface would cut itself after the swaps, it keeps its edges.
// The surface must be free of degenerate triangles and intersections, and is so afterwards.
SwapReport swapDiagonals(SurfaceMesh& surface, double angle, std::vector<char> keep = {});
} // namespace ransmesh

// The repair of faults of a surface that can be mended without changing its shape, reported one by one.
#pragma once

#include "Support/Patch.h"
#include "Triangles/PlaneCutting.h"
#include "Triangles/SurfaceMesh.h"

#include <string>
#include <vector>

namespace ransmesh
{
inline constexpr double AutomaticTolerance = -1;

// Lengths in the surface's unit.
struct RepairOptions
{
  // Points of open edges within this become one, and those within it of another open edge enter it.
  // Automatic: 1e-6 of the surface's largest extent. 0: none.
  double weldTolerance = AutomaticTolerance;
  // Shorter edges are collapsed. Automatic: 1e-9 of the largest extent. 0: none.
  double shortestEdge = AutomaticTolerance;
  // Holes whose border has at most this extent are filled. 0: none.
  double largestHole = 0;
  // Borders in these planes are no holes: the planes close the surface there.
  std::vector<AxisPlane> closedBy = {};
};

// One kind of repair.
struct Repair
{
  std::string text; // what was done, with its number: "2 duplicate triangles dropped"
  std::size_t count = 0;
  Vector3 where; // the first
};

// Welds and stitches borders, drops triangles with two equal corners and duplicates, swaps flat triangles
// with a neighbour, collapses short edges, turns triangles so that neighbours run alike, fills holes, in this
// order. Points of equal coordinates become one, which counts as no repair. Coordinates must be finite.
std::vector<Repair> repairSurface(SurfaceMesh& surface, PatchTable& patches, const RepairOptions& options);
} // namespace ransmesh

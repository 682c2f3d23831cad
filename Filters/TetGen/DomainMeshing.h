// From a checked surface to a tetrahedral mesh: regions, sizes, and a ladder of attempts by TetGen.
#pragma once

#include "Domain.h"
#include "TetGenWorker.h"
#include "Worker/SizeLimits.h"

#include "Mesh/MeshData.h"
#include "Triangles/SurfaceCheck.h"

namespace ransmesh
{
struct MeshingOptions
{
  SizeLimits limits;            // sizes that are asked for in space; its slope holds for the surface too
  double radiusEdgeRatio = 1.4; // the largest that is wanted
  double minimumDihedral = 10;  // degrees, wanted
  bool refine = true;           // false: only the last resort is tried, which inserts no points
};

struct MeshingResult
{
  MeshData mesh;
  std::string switches;             // of the TetGen run that made it
  bool isEndless = false;           // refining did not come to an end
  std::vector<std::string> remarks; // what the user should know
  // On failure: the triangles that are wrong, where they are known.
  SurfaceMesh problemSurface;
  std::vector<SurfaceFinding> problems;
};

// Meshes what the surface, and the box around it if there is one, encloses; the insides of bodies stay
// empty. The surface's triangles are kept as they are, those of sheets as faces inside the mesh; the box's
// sides are divided as the sizes need. TetGen is tried with its own tolerance first, then with finer ones.
// A mesh is given only if it is valid in exact arithmetic.
Outcome meshDomain(const Domain& domain, const MeshingOptions& options, const TetGenWorker& worker,
  const Context& context, MeshingResult& result);
} // namespace ransmesh

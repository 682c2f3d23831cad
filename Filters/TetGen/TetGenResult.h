// What TetGen made, in the kernel's terms.
#pragma once

#include "Worker/Protocol.h"

#include "Mesh/MeshData.h"
#include "Support/Outcome.h"

#include <vector>

namespace ransmesh
{
// A point inside each region that is no fluid. Fluid are the regions that reach a face with one of the given markers
// (patches of the far field) or, if there are none, the outside: those next to the outermost surface. All others are
// the insides of bodies, or shut off by bodies and planes. The result must come from a run with the switch A.
std::vector<Vector3> findHoles(const worker::Result& result, const std::vector<int>& farField);

struct AssembledMesh
{
  MeshData mesh;       // triangles sorted by patch, turned outward
  MeshData unexpected; // points and triangles that have fluid on both sides, but are of no sheet
};

// Turns tetrahedra and triangles as the data contract wants them, and drops unused points. isSheet: by patch.
AssembledMesh assemble(const worker::Result& result, const std::vector<char>& isSheet);
} // namespace ransmesh

// From plain arrays to a mesh that can be changed, or the reason why they are no valid mesh.
#pragma once

#include "Mesh/TetMesh.h"
#include "Support/Outcome.h"

namespace ransmesh
{
// Builds mesh from data. The outcome is BadInput, and mesh stays empty, when the arrays are not a valid
// mesh by findFaults (Mesh/Validation.h). A mesh with sheets must be cut open first (Boundary/Sheets.h): the
// kernel knows triangles of the boundary only. Vertex and tetrahedron numbers are kept; boundary face i is
// triangle i.
Outcome buildTetMesh(const MeshData& data, TetMesh& mesh);
} // namespace ransmesh

#include "Mesh/Builder.h"

#include "Mesh/FaceMatching.h"
#include "Mesh/Validation.h"

namespace ransmesh
{
Outcome buildTetMesh(const MeshData& data, TetMesh& mesh)
{
  FaceMatching matching;
  const MeshFaults faults = findFaults(data, &matching);
  if (!faults.none())
  {
    return Outcome::badInput("the mesh is not valid: " + faults.text());
  }
  if (!matching.sheets.empty())
  {
    return Outcome::internalFault(
      "the mesh has triangles inside: it must be cut open along its sheets first");
  }
  mesh = TetMesh(data, matching.opposite);
  return Outcome::done();
}
} // namespace ransmesh

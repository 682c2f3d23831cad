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
  TetMesh built;
  built.reserve(data.points.size(), data.tetrahedra.size());
  for (const Vector3& x : data.points)
  {
    built.addVertex(x);
  }
  for (const auto& tet : data.tetrahedra)
  {
    built.addTet(tet);
  }
  for (const int patch : data.trianglePatch)
  {
    built.addBoundaryFace(0, patch); // linked to its own face below
  }
  for (std::size_t face = 0; face < matching.opposite.size(); ++face)
  {
    built.link(static_cast<HalfFace>(face), matching.opposite[face]);
  }
  mesh = std::move(built);
  return Outcome::done();
}
} // namespace ransmesh

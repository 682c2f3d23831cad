// Meshes that other programs made, brought into the form of the data contract.
#pragma once

#include "Mesh/MeshData.h"
#include "Support/Outcome.h"
#include "Support/Patch.h"

#include <map>
#include <string>
#include <vector>

namespace ransmesh
{
struct NamedRegions
{
  std::vector<int> of;             // of each tetrahedron, from 1; empty: not known
  std::map<int, std::string> name; // of the numbers that have one
};

// Brings a mesh into the contract's form:
// - points of equal coordinates become one, points that no tetrahedron uses go;
// - tetrahedra are made positive, triangles are turned outward and sorted by patch, repeated ones go;
// - triangles that are no face of a tetrahedron go;
// - triangles between two tetrahedra stay, as sheets; where their patch has triangles on the boundary, too, they go
//   to a patch of their own, `<name>_inside`, of type interface;
// - faces without a triangle between tetrahedra of two regions get one, in a patch `<one>_to_<other>` of type
//   interface;
// - outer faces without a triangle get one, in the patch `boundary`, split where it turns by more than
//   featureAngle degrees (180: one patch).
// mesh.trianglePatch may be 0 where no patch is known. regions.of: the number of each tetrahedron's; where it is empty,
// parts that triangles divide are numbered. What was changed is added to `remarks`, a sentence each.
// BadInput, with the place, where tetrahedra are flat, or the mesh is not valid for other reasons.
Outcome adoptMesh(MeshData& mesh, NamedRegions& regions, PatchTable& patches, double featureAngle,
  std::vector<std::string>& remarks);
} // namespace ransmesh

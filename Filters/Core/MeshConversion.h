// Between vtkUnstructuredGrid, by the data contract, and the kernel's plain arrays.
#ifndef MeshConversion_h
#define MeshConversion_h

#include "Layers/LayerSpecification.h"
#include "Mesh/MeshData.h"
#include "Support/Outcome.h"
#include "Support/Patch.h"

#include "RANSMeshingCoreModule.h"

class vtkFieldData;
class vtkUnstructuredGrid;

namespace ransmesh
{
// Reads points, tetrahedra, boundary triangles and patches. Triangles are turned outward if need be.
// Patches that the field data do not name are named patch_<number>. BadInput for a grid without
// tetrahedra, with cells other than tetrahedra and triangles, or without an integer PatchId array;
// whether the mesh is valid is for the kernel to say (Mesh/Validation.h).
RANSMESHINGCORE_EXPORT Outcome readMesh(vtkUnstructuredGrid* grid, MeshData& mesh, PatchTable& patches);

// Writes the cells of the contract, PatchId and the patch table; grid is emptied first. Triangles must
// come sorted by patch, as toMeshData gives them.
RANSMESHINGCORE_EXPORT void writeMesh(
  const MeshData& mesh, const PatchTable& patches, vtkUnstructuredGrid* grid);

// The layers' specification in field data, so that it is entered once in a chain. Reading gives an
// empty plan where there is none.
RANSMESHINGCORE_EXPORT void writePlan(const LayerPlan& plan, vtkFieldData* fieldData);
RANSMESHINGCORE_EXPORT LayerPlan readPlan(vtkFieldData* fieldData);
} // namespace ransmesh

#endif

// Between vtkUnstructuredGrid and the kernel's meshes of tetrahedra, pyramids, wedges and hexahedra.
#ifndef MixedConversion_h
#define MixedConversion_h

#include "Mesh/MixedMesh.h"
#include "Support/Outcome.h"
#include "Support/Patch.h"

#include "RANSMeshingCoreModule.h"

#include <vector>

class vtkUnstructuredGrid;

namespace ransmesh
{
// Has the grid cells of the contract that are neither tetrahedra nor triangles?
RANSMESHINGCORE_EXPORT bool isMixed(vtkUnstructuredGrid* grid);

// Reads points, cells, boundary and patches, as they are turned. cellIds and boundaryIds receive the grid's numbers
// of the mesh's cells (tetrahedra, pyramids, wedges, hexahedra) and boundary polygons. BadInput for a grid
// with other cells, or without an integer PatchId array.
RANSMESHINGCORE_EXPORT Outcome readMixedMesh(vtkUnstructuredGrid* grid, MixedMesh& mesh, PatchTable& patches,
  std::vector<Index>& cellIds, std::vector<Index>& boundaryIds);

// Writes the cells of the contract, PatchId and the patch table; grid is emptied first.
RANSMESHINGCORE_EXPORT void writeMixedMesh(
  const MixedMesh& mesh, const PatchTable& patches, vtkUnstructuredGrid* grid);
} // namespace ransmesh

#endif

/**
 * @class   vtkNamedBlocksToMesh
 * @brief   a mesh by the data contract from blocks that have names
 *
 * Input: composite data, as vtkMeshToNamedBlocks gives it, or a reader of another mesher's files (of CGNS, for
 * example): blocks of volume cells (tetrahedra, pyramids, wedges, hexahedra) and blocks of faces (triangles,
 * quadrilaterals). Blocks of volume cells together are the volume; each block of faces is a patch with the block's
 * name. Its type is the string PatchType in its field data, or patch.
 *
 * The points of faces are the volume's points of exactly the same coordinates (or, where a face block has the
 * point array MeshPointId and there is one volume, those that it says). A face block with a point that is none of
 * the volume's is an error.
 *
 * Output: a vtkUnstructuredGrid: volume cells, then faces sorted by patch, with PatchId, PatchNames, PatchTypes.
 * Arrays that all blocks of volume cells have are kept on points; arrays that all blocks have, on cells. Whether
 * tetrahedra are positive and faces turned outward is not changed.
 *
 * @sa vtkMeshToNamedBlocks
 */
#ifndef vtkNamedBlocksToMesh_h
#define vtkNamedBlocksToMesh_h

#include "RANSMeshingIOModule.h"
#include "vtkUnstructuredGridAlgorithm.h"

class RANSMESHINGIO_EXPORT vtkNamedBlocksToMesh : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkNamedBlocksToMesh* New();
  vtkTypeMacro(vtkNamedBlocksToMesh, vtkUnstructuredGridAlgorithm);

protected:
  vtkNamedBlocksToMesh() = default;
  ~vtkNamedBlocksToMesh() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkNamedBlocksToMesh(const vtkNamedBlocksToMesh&) = delete;
  void operator=(const vtkNamedBlocksToMesh&) = delete;
};

#endif

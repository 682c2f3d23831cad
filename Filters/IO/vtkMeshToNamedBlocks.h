/**
 * @class   vtkMeshToNamedBlocks
 * @brief   a mesh as blocks that have names: the volume, and each patch
 *
 * Input: a mesh of volume cells and boundary faces with the cell array PatchId and the field data PatchNames and
 * PatchTypes, as the filters of RANSMeshing give it.
 *
 * Output: a vtkPartitionedDataSetCollection. Block 0 is the volume (a vtkUnstructuredGrid on the mesh's own
 * points), each other block a patch (a vtkPolyData on points of its own, with the point array MeshPointId: the
 * point of the mesh that it is; field data PatchType). All have the mesh's arrays; names are the patches'. The
 * assembly has the paths /Mesh/volume/<fluid> and /Mesh/boundary/<patch>; where a name is none that an assembly
 * allows, its node's has underscores, and the attribute "label" holds the name; "type" holds the type.
 *
 * vtkNamedBlocksToMesh makes the mesh again.
 *
 * @sa vtkNamedBlocksToMesh
 */
#ifndef vtkMeshToNamedBlocks_h
#define vtkMeshToNamedBlocks_h

#include "RANSMeshingIOModule.h"
#include "vtkPartitionedDataSetCollectionAlgorithm.h"

class RANSMESHINGIO_EXPORT vtkMeshToNamedBlocks : public vtkPartitionedDataSetCollectionAlgorithm
{
public:
  static vtkMeshToNamedBlocks* New();
  vtkTypeMacro(vtkMeshToNamedBlocks, vtkPartitionedDataSetCollectionAlgorithm);

  /**
   * The mesh, where there is no filter to connect.
   */
  void SetInputData(vtkDataObject* mesh) { this->SetInputDataObject(0, mesh); }

protected:
  vtkMeshToNamedBlocks() = default;
  ~vtkMeshToNamedBlocks() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMeshToNamedBlocks(const vtkMeshToNamedBlocks&) = delete;
  void operator=(const vtkMeshToNamedBlocks&) = delete;
};

#endif

/**
 * @class   vtkMeshAdoption
 * @brief   makes a tetrahedral mesh from another program fit for the chain
 *
 * Stands in the place of vtkIsotropicTetMesher where the isotropic mesh is there already: from gmsh
 * (vtkGmshMeshReader), netgen, or whatever VTK and ParaView read. Its output goes to vtkRANSPointRemoval.
 *
 * Input (repeatable): data sets of tetrahedra and triangles, or composite data of them, as CGNS readers give them:
 * a block of the volume, a block a patch. Points of equal coordinates are one point.
 * The patch of a triangle: the cell array PatchId (names and types: field data PatchNames, PatchTypes); an array of
 * another tool (gmsh:physical, CellEntityIds, medit:ref, su2:tag, netgen:index, ...); the name of a block of
 * triangles. Outer faces without a triangle, or with the number 0, get one: they become the patches boundary,
 * boundary_1, ..., by the angles between them.
 *
 * Output: the mesh by the data contract. Tetrahedra are turned positive, triangles outward. What was changed is
 * told by warnings. A mesh that is not valid even so is an error that says where.
 */
#ifndef vtkMeshAdoption_h
#define vtkMeshAdoption_h

#include "RANSMeshingIOModule.h"
#include "vtkUnstructuredGridAlgorithm.h"

#include <memory>

class RANSMESHINGIO_EXPORT vtkMeshAdoption : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkMeshAdoption* New();
  vtkTypeMacro(vtkMeshAdoption, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Where the boundary turns by more than this, in degrees, 0 to 180, outer faces without a patch become different
   * patches; 180: one patch. Default 30.
   */
  vtkSetMacro(FeatureAngle, double);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  /**
   * Sets the type of the patches that a pattern takes (a name, a name with the wildcards * and ?, or a number):
   * wall, symmetry, farfield, inlet, outlet, wake, interface or patch. Later calls win.
   */
  void SetPatchType(const char* pattern, const char* typeName);
  void ClearPatchTypes();

protected:
  vtkMeshAdoption();
  ~vtkMeshAdoption() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  double FeatureAngle = 30;

private:
  vtkMeshAdoption(const vtkMeshAdoption&) = delete;
  void operator=(const vtkMeshAdoption&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Lists;
};

#endif

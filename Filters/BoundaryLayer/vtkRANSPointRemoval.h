/**
 * @class   vtkRANSPointRemoval
 * @brief   makes room for boundary layers in a tetrahedral mesh
 *
 * Takes the points out of the region that vtkDirectionalEnrichment is going to fill with layers: all
 * that lie within the layers' thickness of a viscous wall, and a little beyond. Points of the walls
 * themselves stay, but for those that lie in another wall's layers at a concave ridge. Where the layers are
 * much thinner than the wall's triangles, nearly nothing changes.
 *
 * Input: a mesh of tetrahedra and boundary triangles with the cell array PatchId, as
 * vtkIsotropicTetMesher gives it; any tetrahedral mesh that keeps this contract will do.
 *
 * Output: the mesh with fewer points, always valid (every tetrahedron positive in exact arithmetic, every
 * face matched). Cell array: PatchId. Point data of the input are kept at the points that remain. Field
 * data: those of the input, the patches, and the layers' specification, which a
 * vtkDirectionalEnrichment that follows uses unless it is told otherwise.
 *
 * After R. Loehner, Generation of non-isotropic unstructured grids via directional enrichment, Int. J.
 * Numer. Meth. Engng 49 (2000) 219-232, section 6.
 *
 * @sa vtkIsotropicTetMesher vtkDirectionalEnrichment vtkMeshQualityReport
 */
#ifndef vtkRANSPointRemoval_h
#define vtkRANSPointRemoval_h

#include "RANSMeshingBoundaryLayerModule.h"
#include "vtkRANSLayerAlgorithm.h"

class RANSMESHINGBOUNDARYLAYER_EXPORT vtkRANSPointRemoval : public vtkRANSLayerAlgorithm
{
public:
  static vtkRANSPointRemoval* New();
  vtkTypeMacro(vtkRANSPointRemoval, vtkRANSLayerAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Of the last execution: points that lay in the layers' region and might go; of these, points that
   * were removed, and points that stayed because the surface's shape needs them: on surfaces and ridges that would
   * turn by more than MaximumSurfaceAngle, or come away from what they were, without them.
   */
  vtkGetMacro(NumberOfMarkedPoints, vtkIdType);
  vtkGetMacro(NumberOfRemovedPoints, vtkIdType);
  vtkGetMacro(NumberOfShapePoints, vtkIdType);
  ///@}

protected:
  vtkRANSPointRemoval() = default;
  ~vtkRANSPointRemoval() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkRANSPointRemoval(const vtkRANSPointRemoval&) = delete;
  void operator=(const vtkRANSPointRemoval&) = delete;

  vtkIdType NumberOfMarkedPoints = 0;
  vtkIdType NumberOfRemovedPoints = 0;
  vtkIdType NumberOfShapePoints = 0;
};

#endif

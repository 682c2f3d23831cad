/**
 * @class   vtkDirectionalEnrichment
 * @brief   layers of stretched tetrahedra on the viscous walls of a tetrahedral mesh
 *
 * Input: a mesh of tetrahedra and boundary triangles with the cell array PatchId, as
 * vtkIsotropicTetMesher and vtkRANSPointRemoval give it; any tetrahedral mesh that keeps this contract
 * will do.
 *
 * Output 0: the enriched mesh, always valid (every tetrahedron positive in exact arithmetic, every face
 * matched). Cell arrays: PatchId; LayerId (0 none, else 1 at the wall, counting outward); PrismId
 * (tetrahedra of one prism share a number, -1 none). Point array: ColumnId (-1 none). Point data of the
 * input are kept; new points take those of the wall point below them. Field data: patches, and the
 * layers' specification.
 *
 * Output 1: the boundary as vtkPolyData with PatchId and, at wall points, LayersAsked, LayersAchieved,
 * FirstHeightAsked, FirstHeightAchieved and StopReason (its names in the field array StopReasonNames);
 * elsewhere 0.
 *
 * After R. Loehner, Generation of non-isotropic unstructured grids via directional enrichment, Int. J.
 * Numer. Meth. Engng 49 (2000) 219-232.
 *
 * @sa vtkRANSPointRemoval vtkIsotropicTetMesher vtkPrismRecombination vtkMeshQualityReport
 */
#ifndef vtkDirectionalEnrichment_h
#define vtkDirectionalEnrichment_h

#include "RANSMeshingBoundaryLayerModule.h"
#include "vtkRANSLayerAlgorithm.h"

class RANSMESHINGBOUNDARYLAYER_EXPORT vtkDirectionalEnrichment : public vtkRANSLayerAlgorithm
{
public:
  static vtkDirectionalEnrichment* New();
  vtkTypeMacro(vtkDirectionalEnrichment, vtkRANSLayerAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Of the last execution: points that the layers asked for after the limits by size, gap and slope;
   * points that were inserted.
   */
  vtkGetMacro(NumberOfRequestedPoints, vtkIdType);
  vtkGetMacro(NumberOfInsertedPoints, vtkIdType);
  ///@}

protected:
  vtkDirectionalEnrichment();
  ~vtkDirectionalEnrichment() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkDirectionalEnrichment(const vtkDirectionalEnrichment&) = delete;
  void operator=(const vtkDirectionalEnrichment&) = delete;

  vtkIdType NumberOfRequestedPoints = 0;
  vtkIdType NumberOfInsertedPoints = 0;
};

#endif

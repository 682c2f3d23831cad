/**
 * @class   vtkPrismRecombination
 * @brief   prisms from the tetrahedra of the layers, for solvers that are cell-centred
 *
 * Input: a mesh of tetrahedra and boundary triangles with the cell arrays PatchId and PrismId, as
 * vtkDirectionalEnrichment gives it, also read back from a file.
 *
 * Output: the same mesh with a wedge in place of the three tetrahedra of each prism, and a hexahedron in place of two
 * such in concave corners and in fans. Where columns end in
 * different levels, pyramids and tetrahedra fill in, so that the mesh stays conforming:
 * quadrilaterals meet quadrilaterals only, those on the boundary are VTK_QUAD cells with their PatchId. All
 * corners of all cells are positive in exact arithmetic. Cells: tetrahedra, pyramids, wedges, hexahedra, then
 * the boundary sorted by patch. Cell arrays of the input are kept (a cell takes the values of one of its
 * tetrahedra), point arrays too. A few points may be added amid prisms that cannot be a wedge on all sides;
 * they take the values of a point beside them, their ColumnId is -1.
 *
 * The points of a wedge stand in VTK's documented order: the triangle 0 1 2 turns away from 3 4 5.
 *
 * @sa vtkDirectionalEnrichment vtkMeshQualityReport
 */
#ifndef vtkPrismRecombination_h
#define vtkPrismRecombination_h

#include "RANSMeshingBoundaryLayerModule.h"
#include "vtkUnstructuredGridAlgorithm.h"

class RANSMESHINGBOUNDARYLAYER_EXPORT vtkPrismRecombination : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkPrismRecombination* New();
  vtkTypeMacro(vtkPrismRecombination, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Points beyond the layers move where a face of their tetrahedra is less orthogonal than this: the angle between
   * its normal and the line between the centres of its cells, in degrees, 0 to 90. Cell-centred solvers warn above
   * 70, which is the default. 90: no point moves.
   */
  vtkSetClampMacro(MaximumNonOrthogonality, double, 0, 90);
  vtkGetMacro(MaximumNonOrthogonality, double);
  ///@}

  ///@{
  /**
   * Of the last execution: the share of the layers' tetrahedra that became wedges or hexahedra, 0 to 1; the numbers of
   * wedges, hexahedra and pyramids; points added; points beyond the layers that moved.
   */
  vtkGetMacro(ShareOfLayers, double);
  vtkGetMacro(NumberOfWedges, vtkIdType);
  vtkGetMacro(NumberOfHexahedra, vtkIdType);
  vtkGetMacro(NumberOfPyramids, vtkIdType);
  vtkGetMacro(NumberOfAddedPoints, vtkIdType);
  vtkGetMacro(NumberOfMovedPoints, vtkIdType);
  ///@}

protected:
  vtkPrismRecombination() = default;
  ~vtkPrismRecombination() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPrismRecombination(const vtkPrismRecombination&) = delete;
  void operator=(const vtkPrismRecombination&) = delete;

  double MaximumNonOrthogonality = 70;
  double ShareOfLayers = 0;
  vtkIdType NumberOfWedges = 0;
  vtkIdType NumberOfHexahedra = 0;
  vtkIdType NumberOfPyramids = 0;
  vtkIdType NumberOfAddedPoints = 0;
  vtkIdType NumberOfMovedPoints = 0;
};

#endif

/**
 * @class   vtkMeshQualityReport
 * @brief   is a tetrahedral mesh valid, how good are its cells, how complete its layers?
 *
 * Input 0: a mesh of tetrahedra and boundary triangles with the cell array PatchId, from any filter of the
 * chain or from elsewhere. The layers that were asked for are read from its field data; without them, the
 * report is on validity, sizes and shapes alone. Input 1, optional: the second output of
 * vtkDirectionalEnrichment; the report then says also why columns stopped.
 *
 * Output 0: the mesh with the cell arrays Volume, LargestDihedral, SmallestDihedral (degrees), Stretching
 * (longest edge over smallest height) and Quality (volume over the cube of the root-mean-square edge, 1
 * for the regular tetrahedron). Boundary triangles show the tetrahedron behind them, but have no Volume.
 *
 * Output 1: a vtkTable with a row for each figure: Quantity, Value, Unit, Scope ("whole", "layers" or a
 * patch's name).
 *
 * Output 2: a vtkTable with a row for each bin of each histogram: Histogram (a number), Quantity, Scope,
 * BinLow, BinHigh, Count.
 *
 * A mesh with prisms, as vtkPrismRecombination gives it, is checked as it is and measured as the tetrahedra that
 * its cells can be cut into; a cell shows the worst of them.
 *
 * A mesh that is not valid is reported, not an error; cells that the data contract does not know, and a mesh
 * without cells of the fluid, are errors. Each figure is defined in vtkMeshQualityReport.md.
 *
 * @sa vtkIsotropicTetMesher vtkRANSPointRemoval vtkDirectionalEnrichment
 */
#ifndef vtkMeshQualityReport_h
#define vtkMeshQualityReport_h

#include "RANSMeshingBoundaryLayerModule.h"
#include "vtkUnstructuredGridAlgorithm.h"

#include <memory>

class RANSMESHINGBOUNDARYLAYER_EXPORT vtkMeshQualityReport : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkMeshQualityReport* New();
  vtkTypeMacro(vtkMeshQualityReport, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Factor by which a spacing may be off from the one asked for, above 1. Default 1.3.
   */
  vtkSetClampMacro(SpacingTolerance, double, 1, 1e6);
  vtkGetMacro(SpacingTolerance, double);
  ///@}

  ///@{
  /**
   * How far an edge of a column may lean from the wall's normal, degrees, 0 to 90. Default 20.
   */
  vtkSetClampMacro(ColumnCone, double, 0, 90);
  vtkGetMacro(ColumnCone, double);
  ///@}

  ///@{
  /**
   * Columns are counted on wall points where no wall face turns by this or more from their mean normal,
   * degrees, 0 to 90. Default 20.
   */
  vtkSetClampMacro(SmoothAngle, double, 0, 90);
  vtkGetMacro(SmoothAngle, double);
  ///@}

  /**
   * Of the last execution: is the mesh valid, exactly?
   */
  vtkGetMacro(Valid, bool);

  ///@{
  /**
   * The report of the last execution, as text for a terminal and as JSON; empty before.
   */
  const char* GetReportText() const;
  const char* GetReportJson() const;
  ///@}

  /**
   * Writes the report of the last execution to a file, as JSON. False, with an error event, if there is no
   * report yet or the file cannot be written.
   */
  bool WriteJson(const char* fileName);

protected:
  vtkMeshQualityReport();
  ~vtkMeshQualityReport() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double SpacingTolerance;
  double ColumnCone;
  double SmoothAngle;
  bool Valid = false;

private:
  vtkMeshQualityReport(const vtkMeshQualityReport&) = delete;
  void operator=(const vtkMeshQualityReport&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Results;
};

#endif

/**
 * @class   vtkSurfaceCheck
 * @brief   says whether surfaces can bound a mesh, and if not, what is wrong and where
 *
 * Looks at triangulated surfaces as they are, and changes nothing: coordinates that are no numbers,
 * degenerate and duplicate triangles, open edges, edges and points where more than one sheet of the surface
 * meets, triangles that run against their neighbours, triangles that cross, sheets that nearly coincide; and
 * the pieces that the surface consists of, and which of them lies in which.
 *
 * Input (repeatable): vtkPolyData, or composite data of them, each triangle with a patch (cell array PatchId,
 * arrays of other tools, else one patch a block): what vtkIsotropicTetMesher takes.
 * Output 0: the triangles that are wrong, one cell a finding, with the cell arrays Reason (an index into the
 * field data ReasonNames), PartnerId (the cell here that shows the other triangle of a pair, or -1), PatchId.
 * Output 1: a vtkTable with a row for each kind of fault (of crossings and near sheets, for each pair of
 * patches): Kind, Count, Triangles, Patches, X, Y, Z (of the first).
 * Output 2: a vtkTable with a row for each connected piece: Piece, Triangles, OpenEdges, Area, Volume (0 unless
 * it is closed; below 0 where it faces inward), EnclosedBy (a piece, or -1), Patches, XMin ... ZMax.
 *
 * A surface that is wrong is a result, not an error; errors are inputs that hold no surface.
 *
 * @sa vtkSurfaceRepair vtkSurfaceWrap vtkIsotropicTetMesher
 */
#ifndef vtkSurfaceCheck_h
#define vtkSurfaceCheck_h

#include "RANSMeshingSurfaceModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <memory>

class RANSMESHINGSURFACE_EXPORT vtkSurfaceCheck : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceCheck* New();
  vtkTypeMacro(vtkSurfaceCheck, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Sheets that come nearer to each other than this times the largest extent of the surfaces, without touching,
   * and nearer than a tenth of their edges, are reported, 0 to 0.1; 0: they are not looked for. Default 1e-6.
   * They can be meshed, but the mesh between them is fine, and TetGen may not tell them apart.
   */
  vtkSetClampMacro(NearTolerance, double, 0, 0.1);
  vtkGetMacro(NearTolerance, double);
  ///@}

  ///@{
  /**
   * Whether triangles that cross, and near sheets, are looked for: the only test that takes time. Default on.
   */
  vtkSetMacro(Intersections, bool);
  vtkGetMacro(Intersections, bool);
  vtkBooleanMacro(Intersections, bool);
  ///@}

  /**
   * Of the last execution: could the surface bound a mesh as it is? Non-manifold edges and points, turned
   * triangles and near sheets alone do not prevent that.
   */
  vtkGetMacro(Sound, bool);

  /**
   * Of the last execution: what is wrong, and what can be done, in sentences; empty before.
   */
  const char* GetReportText() const;

protected:
  vtkSurfaceCheck();
  ~vtkSurfaceCheck() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  double NearTolerance = 1e-6;
  bool Intersections = true;
  bool Sound = false;

private:
  struct Internals;
  std::unique_ptr<Internals> Results;

  vtkSurfaceCheck(const vtkSurfaceCheck&) = delete;
  void operator=(const vtkSurfaceCheck&) = delete;
};

#endif

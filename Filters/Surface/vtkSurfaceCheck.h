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
 * Output 1: a vtkTable with a row for each kind of fault: Kind, Count, Patches, X, Y, Z (of the first).
 *
 * A surface that is wrong is a result, not an error; errors are inputs that hold no surface.
 *
 * @sa vtkSurfaceRepair vtkSurfaceWrap vtkIsotropicTetMesher
 */
#ifndef vtkSurfaceCheck_h
#define vtkSurfaceCheck_h

#include "RANSMeshingSurfaceModule.h"
#include "vtkPolyDataAlgorithm.h"

class RANSMESHINGSURFACE_EXPORT vtkSurfaceCheck : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceCheck* New();
  vtkTypeMacro(vtkSurfaceCheck, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSurfaceCheck();
  ~vtkSurfaceCheck() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  vtkSurfaceCheck(const vtkSurfaceCheck&) = delete;
  void operator=(const vtkSurfaceCheck&) = delete;
};

#endif

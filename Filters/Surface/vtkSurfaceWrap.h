/**
 * @class   vtkSurfaceWrap
 * @brief   a closed surface around parts that are open, doubled, or cross
 *
 * For surfaces that no repair closes: wraps them from outside (CGAL's alpha wrapping, after Portaneri et al.,
 * SIGGRAPH 2022). The wrap is closed, oriented outward, without crossings, and lies at a distance of about Offset
 * outside the given surface; what is narrower than Alpha is bridged, and what lies inside is not kept. Sharp edges
 * become blunt by about the offset. Each new triangle belongs to the patch of the nearest given triangle.
 *
 * Input (repeatable): vtkPolyData, or composite data of them, each triangle with a patch.
 * Output: the wrap as one vtkPolyData, with the cell array PatchId, the field data PatchNames and PatchTypes, and the
 * field data WrapAlpha and WrapOffset.
 *
 * @sa vtkSurfaceCheck vtkSurfaceRepair vtkIsotropicTetMesher
 */
#ifndef vtkSurfaceWrap_h
#define vtkSurfaceWrap_h

#include "RANSMeshingSurfaceModule.h"
#include "vtkPolyDataAlgorithm.h"

class RANSMESHINGSURFACE_EXPORT vtkSurfaceWrap : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceWrap* New();
  vtkTypeMacro(vtkSurfaceWrap, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The size of what is bridged, and about that of the new triangles, in the unit of the surface. Default 0: a
   * hundredth of the largest extent.
   */
  vtkSetMacro(Alpha, double);
  vtkGetMacro(Alpha, double);
  ///@}

  ///@{
  /**
   * How far outside the given surface the wrap lies, in its unit. Default 0: a thirtieth of Alpha.
   */
  vtkSetMacro(Offset, double);
  vtkGetMacro(Offset, double);
  ///@}

  ///@{
  /**
   * Alpha and Offset of the last execution, with defaults put in; 0 before.
   */
  vtkGetMacro(AlphaUsed, double);
  vtkGetMacro(OffsetUsed, double);
  ///@}

protected:
  vtkSurfaceWrap() = default;
  ~vtkSurfaceWrap() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  double Alpha = 0;
  double Offset = 0;
  double AlphaUsed = 0;
  double OffsetUsed = 0;

private:
  vtkSurfaceWrap(const vtkSurfaceWrap&) = delete;
  void operator=(const vtkSurfaceWrap&) = delete;
};

#endif

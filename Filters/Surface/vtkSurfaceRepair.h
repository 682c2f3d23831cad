/**
 * @class   vtkSurfaceRepair
 * @brief   mends what can be mended without changing a surface's shape, and says what it did
 *
 * Welds or stitches borders that nearly coincide, drops degenerate and duplicate triangles, collapses edges
 * that are too short to be meant, turns triangles that run against their neighbours, and fills holes, if that
 * is asked for. vtkIsotropicTetMesher does the same with the same options; this filter shows what comes out.
 *
 * Input (repeatable): vtkPolyData, or composite data of them, each triangle with a patch.
 * Output 0: the surface as one vtkPolyData, with the cell array PatchId and the field data PatchNames and
 * PatchTypes.
 * Output 1: a vtkTable with a row for each kind of repair that was made: Repair (a sentence), Count, X, Y, Z.
 *
 * Coordinates that are not finite are an error. Whether the surface is sound then, vtkSurfaceCheck tells.
 *
 * @sa vtkSurfaceCheck vtkSurfaceWrap vtkIsotropicTetMesher
 */
#ifndef vtkSurfaceRepair_h
#define vtkSurfaceRepair_h

#include "RANSMeshingSurfaceModule.h"
#include "vtkPolyDataAlgorithm.h"

class RANSMESHINGSURFACE_EXPORT vtkSurfaceRepair : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceRepair* New();
  vtkTypeMacro(vtkSurfaceRepair, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Points of open edges that lie within this distance of each other, in the unit of the surface, become one, and
   * those that lie within it of another open edge enter that edge. 0: none. Default -1: a millionth of the
   * largest extent.
   */
  vtkSetMacro(WeldTolerance, double);
  vtkGetMacro(WeldTolerance, double);
  ///@}

  ///@{
  /**
   * Edges shorter than this, in the unit of the surface, are collapsed, where that changes neither how the
   * surface hangs together nor a patch's border. 0: none. Default -1: 1e-9 of the largest extent.
   */
  vtkSetMacro(ShortestEdge, double);
  vtkGetMacro(ShortestEdge, double);
  ///@}

  ///@{
  /**
   * Holes whose border has at most this extent along each axis, in the unit of the surface, are filled; those of
   * more than 12 edges become patches of their own, hole_1 and so on. Default 0: none.
   */
  vtkSetMacro(LargestHole, double);
  vtkGetMacro(LargestHole, double);
  ///@}

protected:
  vtkSurfaceRepair();
  ~vtkSurfaceRepair() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  double WeldTolerance = -1;
  double ShortestEdge = -1;
  double LargestHole = 0;

private:
  vtkSurfaceRepair(const vtkSurfaceRepair&) = delete;
  void operator=(const vtkSurfaceRepair&) = delete;
};

#endif

/**
 * @class   vtkSurfaceRemesher
 * @brief   gives a surface triangles of good shape and wanted size, and keeps its form
 *
 * Edges are split, collapsed and swapped, and points moved along the surface, until the triangles are nearly
 * equilateral and of the sizes that are wanted: one for all, by patch, by a point array, by the surface's
 * curvature and by gaps. Points lie on the given surface. Edges where the surface turns by more than
 * FeatureAngle, borders of patches and open borders stay as lines; corners stay as points. How far the new
 * triangles lie from the given ones is bounded, measured and told by a warning.
 *
 * Input (repeatable): vtkPolyData, or composite data of them, each triangle with a patch (cell array PatchId,
 * arrays of other tools, else one patch a block): what vtkIsotropicTetMesher takes.
 * Output: the surface as one vtkPolyData, with the cell array PatchId and the field data PatchNames and
 * PatchTypes. Patches of type interface stay as they are.
 *
 * Lengths are in the unit of the surface. With no size given, edges are a tenth of their patch's extent.
 * vtkIsotropicTetMesher does the same with the same options.
 *
 * @sa vtkSurfaceCheck vtkSurfaceRepair vtkIsotropicTetMesher
 */
#ifndef vtkSurfaceRemesher_h
#define vtkSurfaceRemesher_h

#include "RANSMeshingSurfaceModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <memory>

class RANSMESHINGSURFACE_EXPORT vtkSurfaceRemesher : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceRemesher* New();
  vtkTypeMacro(vtkSurfaceRemesher, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The largest edge wanted. Default 0: a tenth of the patch's largest extent, or, if only PatchEdgeLengths are
   * given, other patches are kept.
   */
  vtkSetMacro(EdgeLength, double);
  vtkGetMacro(EdgeLength, double);
  ///@}

  /**
   * The largest edge on the patches that a pattern takes (a name, a name with the wildcards * and ?, or a
   * number), above 0, in place of EdgeLength. Later calls win.
   */
  void SetPatchEdgeLength(const char* pattern, double length);
  void ClearPatchEdgeLengths();

  ///@{
  /**
   * How many edges a full circle of the surface's curvature, or of a curved line, is to have; 12 to 36 are usual.
   * Default 0: curvature does not matter.
   */
  vtkSetMacro(EdgesPerCircle, double);
  vtkGetMacro(EdgesPerCircle, double);
  ///@}

  ///@{
  /**
   * How many edges are to fit between the surface and the next part of it that faces it. Default 0: gaps do not
   * matter.
   */
  vtkSetMacro(EdgesAcrossGap, double);
  vtkGetMacro(EdgesAcrossGap, double);
  ///@}

  ///@{
  /**
   * Where gaps are looked for: 0 on both sides of the surface, 1 outside of what it encloses, 2 inside.
   * Default 0.
   */
  vtkSetClampMacro(GapSide, int, 0, 2);
  vtkGetMacro(GapSide, int);
  ///@}

  ///@{
  /**
   * Curvature and gaps ask for no smaller edges than this. Default 0: a hundredth of the largest.
   */
  vtkSetMacro(SmallestEdgeLength, double);
  vtkGetMacro(SmallestEdgeLength, double);
  ///@}

  ///@{
  /**
   * How fast edges may grow along the surface: the ratio of successive ones, 1.01 to 3. Default 1.3.
   */
  vtkSetMacro(GrowthRate, double);
  vtkGetMacro(GrowthRate, double);
  ///@}

  ///@{
  /**
   * How far a new triangle may lie from the given surface. Default 0: a twentieth of the wanted edge.
   */
  vtkSetMacro(MaximumDeviation, double);
  vtkGetMacro(MaximumDeviation, double);
  ///@}

  ///@{
  /**
   * Edges where the surface turns by more than this, in degrees, 0 to 180, are kept as lines. Default 30.
   */
  vtkSetMacro(FeatureAngle, double);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * The name of a point array with the largest edge wanted at each point; 0 and less mean none. Default empty: no
   * array.
   */
  vtkSetStringMacro(SizeArray);
  vtkGetStringMacro(SizeArray);
  ///@}

  ///@{
  /**
   * After the update: the largest distance between the given surface and the new one, either way, at points and
   * middles of edges and triangles; and the angle, in degrees, that 99 % of the new triangles' smallest angles
   * exceed.
   */
  vtkGetMacro(Deviation, double);
  vtkGetMacro(LowAngle, double);
  ///@}

protected:
  vtkSurfaceRemesher();
  ~vtkSurfaceRemesher() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  double EdgeLength = 0;
  double EdgesPerCircle = 0;
  double EdgesAcrossGap = 0;
  int GapSide = 0;
  double SmallestEdgeLength = 0;
  double GrowthRate = 1.3;
  double MaximumDeviation = 0;
  double FeatureAngle = 30;
  char* SizeArray = nullptr;
  double Deviation = 0;
  double LowAngle = 0;

private:
  vtkSurfaceRemesher(const vtkSurfaceRemesher&) = delete;
  void operator=(const vtkSurfaceRemesher&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Lists;

  bool OptionsAreValid();
};

#endif

/**
 * @class   vtkIsotropicTetMesher
 * @brief   fills closed triangulated surfaces with isotropic tetrahedra
 *
 * First stage of the chain to a RANS mesh: meshes the domain that the input surfaces bound, or, with
 * FarField, the space between the input bodies and a box or sphere around them. Planes of symmetry, a waterline
 * and the ground cut the surfaces and close the domain. The insides of bodies are found and left empty. Surface
 * triangles are kept, except that very obtuse ones are improved, that edges longer than the wanted size are
 * halved, and that surfaces are remeshed on demand; sizes in the volume grow away from the surface. TetGen does
 * the work, in a process of its own: whatever happens there becomes an error of this filter.
 *
 * Input (repeatable): vtkPolyData, or composite data of them; closed together; each triangle with a patch
 * (cell array PatchId, arrays of other tools, else one patch a block).
 * Input 1 (optional, repeatable): sheets, in the same form, but open.
 * Output 0: the mesh by the data contract of the project: tetrahedra, then boundary triangles sorted by
 * patch and turned outward (those of sheets once, as they come), with PatchId, PatchNames, PatchTypes; field
 * data MesherSwitches, SurfaceSwaps, SurfaceSplits.
 * Output 1: the triangles that are wrong with the surface, with Reason, PartnerId, PatchId. If these are
 * known, the filter reports the error and ends with an empty mesh, so that they can be shown.
 */
#ifndef vtkIsotropicTetMesher_h
#define vtkIsotropicTetMesher_h

#include "RANSMeshingTetGenModule.h"
#include "vtkDomainAlgorithm.h"

#include <memory>
#include <string>

class vtkPolyData;

namespace ransmesh
{
struct MesherReport;
struct MesherSettings;
struct Outcome;
} // namespace ransmesh

class RANSMESHINGTETGEN_EXPORT vtkIsotropicTetMesher : public vtkDomainAlgorithm
{
public:
  static vtkIsotropicTetMesher* New();
  vtkTypeMacro(vtkIsotropicTetMesher, vtkDomainAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The largest edge that is wanted anywhere, in the unit of the surface. Surface edges longer than 1.5
   * times this are halved. Default 0: no limit but the growth away from the surface.
   */
  vtkSetMacro(MaximumEdgeLength, double);
  vtkGetMacro(MaximumEdgeLength, double);
  ///@}

  ///@{
  /**
   * The edge length to which the surfaces are remeshed, in their unit; edges where the surface turns by more
   * than FeatureAngle and the borders of patches are kept. Default 0: the surface triangles are kept.
   */
  vtkSetMacro(SurfaceEdgeLength, double);
  vtkGetMacro(SurfaceEdgeLength, double);
  ///@}

  /**
   * The edge length to which the patches that a pattern takes (a name, a name with the wildcards * and ?, or a
   * number) are remeshed, above 0; if nothing else asks for remeshing, other patches are kept. Later calls win.
   */
  void SetPatchEdgeLength(const char* pattern, double length);
  void ClearPatchEdgeLengths();

  ///@{
  /**
   * How many edges a full circle of the surface's curvature, or of a curved line of edges, is to have; 12 to 36 are
   * usual; remeshes the surface. Default 0: curvature does not matter.
   */
  vtkSetMacro(EdgesPerCircle, double);
  vtkGetMacro(EdgesPerCircle, double);
  ///@}

  ///@{
  /**
   * How many edges are to fit between the surface and the next part of it that faces it across the fluid; remeshes
   * the surface. Default 0: gaps do not matter.
   */
  vtkSetMacro(EdgesAcrossGap, double);
  vtkGetMacro(EdgesAcrossGap, double);
  ///@}

  ///@{
  /**
   * Curvature and gaps ask for no smaller edges than this, in the unit of the surface. Default 0: a hundredth of the
   * largest.
   */
  vtkSetMacro(SmallestSurfaceEdgeLength, double);
  vtkGetMacro(SmallestSurfaceEdgeLength, double);
  ///@}

  ///@{
  /**
   * How far a remeshed triangle may lie from the given surface, in its unit. Default 0: a twentieth of the wanted
   * edge.
   */
  vtkSetMacro(MaximumSurfaceDeviation, double);
  vtkGetMacro(MaximumSurfaceDeviation, double);
  ///@}

  ///@{
  /**
   * The name of a point array of the surfaces with the largest edge that is wanted at each point, 0 and less meaning
   * none; remeshes the surface. Default empty: no array.
   */
  vtkSetStringMacro(SurfaceSizeArray);
  vtkGetStringMacro(SurfaceSizeArray);
  ///@}

  ///@{
  /**
   * Whether very obtuse surface triangles are improved: tetrahedra are no better than the triangles that they
   * stand on. The diagonal of two triangles of a patch is swapped where that lowers the largest of their
   * angles and this is above 150 degrees; what is above 177 degrees then gets a point on its longest side.
   * No point moves; patches of type interface stay as they are. Reported by a warning and by the field data
   * SurfaceSwaps and SurfaceSplits, the numbers of swaps and of new points. Default on.
   */
  vtkSetMacro(ImproveSurfaceTriangles, bool);
  vtkGetMacro(ImproveSurfaceTriangles, bool);
  vtkBooleanMacro(ImproveSurfaceTriangles, bool);
  ///@}

  ///@{
  /**
   * How far, in degrees, 0 to 90, swaps may turn the surface: a new triangle lies within this angle of both
   * that it replaces. Edges that turn by more than twice the angle are never swapped. Default 10.
   */
  vtkSetMacro(MaximumSurfaceAngle, double);
  vtkGetMacro(MaximumSurfaceAngle, double);
  ///@}

  ///@{
  /**
   * Ratio of the sizes of successive tetrahedra away from the surface, 1.01 to 3. Default 1.3.
   */
  vtkSetMacro(SurfaceGrowthRate, double);
  vtkGetMacro(SurfaceGrowthRate, double);
  ///@}

  ///@{
  /**
   * The largest ratio of circumradius to shortest edge that is wanted of a tetrahedron, 1.1 to 10; less is
   * better and costs more points. Default 1.4. Where the given surface does not allow it, it is exceeded.
   */
  vtkSetMacro(MaximumRadiusEdgeRatio, double);
  vtkGetMacro(MaximumRadiusEdgeRatio, double);
  ///@}

  ///@{
  /**
   * The smallest dihedral angle that is wanted of a tetrahedron, in degrees, 0 to 18. Default 10. Where the
   * given surface does not allow it, it is undercut.
   */
  vtkSetMacro(MinimumDihedralAngle, double);
  vtkGetMacro(MinimumDihedralAngle, double);
  ///@}

  /**
   * Asks for edges of at most `size` in a box; around it sizes grow by SurfaceGrowthRate.
   */
  void AddRefinementBox(
    double xmin, double xmax, double ymin, double ymax, double zmin, double zmax, double size);
  /**
   * Asks for edges of at most `size` in a sphere; around it sizes grow by SurfaceGrowthRate.
   */
  void AddRefinementSphere(double cx, double cy, double cz, double radius, double size);
  /**
   * Asks for edges of at most `size` within a radius (0: on it alone) of a line; around it sizes grow by
   * SurfaceGrowthRate.
   */
  void AddRefinementLine(
    double x1, double y1, double z1, double x2, double y2, double z2, double radius, double size);
  void ClearRefinements();
  void ClearRefinementBoxes();
  void ClearRefinementSpheres();
  void ClearRefinementLines();

  ///@{
  /**
   * The worker program that runs TetGen. Default: empty, which takes the environment variable
   * RANSMESH_WORKER, or else the program installed or built with this library.
   */
  vtkSetFilePathMacro(WorkerExecutable);
  vtkGetFilePathMacro(WorkerExecutable);
  ///@}

  ///@{
  /**
   * Seconds after which a run of TetGen is stopped and counts as failed; up to six runs may follow each
   * other. Default 0: no limit.
   */
  vtkSetMacro(WorkerTimeLimit, double);
  vtkGetMacro(WorkerTimeLimit, double);
  ///@}

  ///@{
  /**
   * Megabytes of memory (of 1e6 bytes) that a run of TetGen may take; what needs more counts as failed. A million
   * tetrahedra take about 500. Default 0: no limit.
   */
  vtkSetMacro(WorkerMemoryLimit, double);
  vtkGetMacro(WorkerMemoryLimit, double);
  ///@}

protected:
  vtkIsotropicTetMesher();
  ~vtkIsotropicTetMesher() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  double MaximumEdgeLength = 0;
  double SurfaceEdgeLength = 0;
  double EdgesPerCircle = 0;
  double EdgesAcrossGap = 0;
  double SmallestSurfaceEdgeLength = 0;
  double MaximumSurfaceDeviation = 0;
  char* SurfaceSizeArray = nullptr;
  bool ImproveSurfaceTriangles = true;
  double MaximumSurfaceAngle = 10;
  double SurfaceGrowthRate = 1.3;
  double MaximumRadiusEdgeRatio = 1.4;
  double MinimumDihedralAngle = 10;
  char* WorkerExecutable = nullptr;
  double WorkerTimeLimit = 0;
  double WorkerMemoryLimit = 0;

private:
  vtkIsotropicTetMesher(const vtkIsotropicTetMesher&) = delete;
  void operator=(const vtkIsotropicTetMesher&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Lists;

  bool OptionsAreValid();
  std::string FindWorker();
  ransmesh::MesherSettings GetSettings() const;
  // Reports why there is no mesh, and shows the triangles that are wrong. Gives RequestData's answer.
  int Refuse(const ransmesh::Outcome& outcome, const ransmesh::MesherReport& report, vtkPolyData* problems);
};

#endif

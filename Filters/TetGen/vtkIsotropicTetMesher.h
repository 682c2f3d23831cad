/**
 * @class   vtkIsotropicTetMesher
 * @brief   fills closed triangulated surfaces with isotropic tetrahedra
 *
 * First stage of the chain to a RANS mesh: meshes the domain that the input surfaces bound, or, with
 * FarField, the space between the input bodies and a box or sphere around them. Planes of symmetry, a waterline
 * and the ground cut the surfaces and close the domain. The insides of bodies are found and left empty. Surface triangles are kept, except that very obtuse ones are improved, that edges
 * longer than the wanted size are halved, and that surfaces are remeshed on demand; sizes in the volume grow away from the surface. TetGen does the work, in a process of its own: whatever
 * happens there becomes an error of this filter.
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
#include "vtkUnstructuredGridAlgorithm.h"

#include <memory>
#include <string>

class vtkAlgorithmOutput;
class vtkDataObject;
class vtkPolyData;

namespace ransmesh
{
struct MesherReport;
struct MesherSettings;
struct Outcome;
} // namespace ransmesh

class RANSMESHINGTETGEN_EXPORT vtkIsotropicTetMesher : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkIsotropicTetMesher* New();
  vtkTypeMacro(vtkIsotropicTetMesher, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Adds sheets to the second input: open surfaces inside the domain, which become faces of the mesh with
   * tetrahedra on both sides. They are wakes (type wake), or, by SetPatchType, walls without thickness (type
   * wall). A sheet's border may lie free, or on a surface or another sheet, where its points must coincide
   * with points there (within 1e-6 of the surfaces' largest extent) and its edges with edges; or on a side of
   * the far-field box.
   */
  void AddSheetData(vtkDataObject* sheets);
  void AddSheetConnection(vtkAlgorithmOutput* sheets);
  void RemoveAllSheets();
  ///@}

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
   * Whether faults of the surface are mended where that does not change its shape, by the three lengths below:
   * nearly coincident borders, triangles without area or given twice, edges too short to be meant, triangles
   * that run against their neighbours. Each repair is reported by a warning. Off: points of equal coordinates become
   * one, and nothing else is changed. Default on. See vtkSurfaceRepair, which does the same and shows it.
   */
  vtkSetMacro(Repair, bool);
  vtkGetMacro(Repair, bool);
  vtkBooleanMacro(Repair, bool);
  ///@}

  ///@{
  /**
   * Points of open edges that lie within this distance of each other, in the unit of the surface, become one. 0:
   * none. Default -1: a millionth of the largest extent.
   */
  vtkSetMacro(WeldTolerance, double);
  vtkGetMacro(WeldTolerance, double);
  ///@}

  ///@{
  /**
   * Surface edges shorter than this, in the unit of the surface, are collapsed. 0: none. Default -1: 1e-9 of the
   * largest extent.
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

  ///@{
  /**
   * Whether the surfaces are bodies in a box that is added around them. Bodies whose names suggest no type
   * become walls. Default off: the surfaces bound the domain.
   */
  vtkSetMacro(FarField, bool);
  vtkGetMacro(FarField, bool);
  vtkBooleanMacro(FarField, bool);
  ///@}

  ///@{
  /**
   * Distances from the bodies to the box's sides xmin, xmax, ymin, ymax, zmin, zmax, each > 0, in body
   * lengths (the largest extent of all bodies along an axis). Default 5 each. The sides become the patches
   * farfield_xmin ... farfield_zmax.
   */
  vtkSetVector6Macro(FarFieldMargins, double);
  vtkGetVector6Macro(FarFieldMargins, double);
  ///@}

  enum FarFieldShapes
  {
    BOX = 0,
    SPHERE = 1
  };
  ///@{
  /**
   * The shape of the far field: BOX, or SPHERE, one patch `farfield`, whose distance from the bodies is the first
   * of FarFieldMargins; its triangles have edges of a fifth of its radius, or of MaximumEdgeLength if that is
   * less. Default BOX.
   */
  vtkSetClampMacro(FarFieldShape, int, BOX, SPHERE);
  vtkGetMacro(FarFieldShape, int);
  void SetFarFieldShapeToBox() { this->SetFarFieldShape(BOX); }
  void SetFarFieldShapeToSphere() { this->SetFarFieldShape(SPHERE); }
  ///@}

  ///@{
  /**
   * Names a side of the far-field box (xmin, xmax, ymin, ymax, zmin or zmax). type: as in SetPatchType; empty or
   * null: what the name suggests (inlet, outlet, symmetry, ...), else farfield. Sides of one name are one patch.
   */
  void SetFarFieldSide(const char* side, const char* name, const char* type = nullptr);
  void ClearFarFieldSides();
  ///@}

  enum PlaneAxes
  {
    NO_PLANE = 0,
    ACROSS_X = 1,
    ACROSS_Y = 2,
    ACROSS_Z = 3
  };
  ///@{
  /**
   * A plane of symmetry across an axis, at SymmetryPosition, in the unit of the surface: NO_PLANE, ACROSS_X,
   * ACROSS_Y or ACROSS_Z. The surfaces are cut there; the side on which they reach farther stays (the side above
   * if that is equal). A half model may end in the plane, with open edges that lie in it within 1e-6 of its
   * largest extent. The plane becomes the patch `symmetry` of type symmetry: a side of the far-field box, the cut
   * through the sphere, or what closes the surfaces there. Default NO_PLANE, at 0.
   */
  vtkSetClampMacro(SymmetryPlane, int, NO_PLANE, ACROSS_Z);
  vtkGetMacro(SymmetryPlane, int);
  vtkSetMacro(SymmetryPosition, double);
  vtkGetMacro(SymmetryPosition, double);
  ///@}

  ///@{
  /**
   * The undisturbed surface of the water, across an axis, at WaterlinePosition: what lies above it is cut off.
   * It becomes the patch `waterline` of type symmetry. Default NO_PLANE, at 0.
   */
  vtkSetClampMacro(WaterlinePlane, int, NO_PLANE, ACROSS_Z);
  vtkGetMacro(WaterlinePlane, int);
  vtkSetMacro(WaterlinePosition, double);
  vtkGetMacro(WaterlinePosition, double);
  ///@}

  ///@{
  /**
   * The ground, across an axis, at GroundPosition: what lies below it is cut off. Wheels must reach into it a
   * little: where they merely touch it, the gap beside the contact ends in a wedge without angle. It becomes the
   * patch `ground` of type wall. Default NO_PLANE, at 0.
   */
  vtkSetClampMacro(GroundPlane, int, NO_PLANE, ACROSS_Z);
  vtkGetMacro(GroundPlane, int);
  vtkSetMacro(GroundPosition, double);
  vtkGetMacro(GroundPosition, double);
  ///@}

  ///@{
  /**
   * Whether an input (or block) without any patch numbers is split into patches where its surface turns by
   * more than FeatureAngle. Default off.
   */
  vtkSetMacro(PatchFromFeatureAngle, bool);
  vtkGetMacro(PatchFromFeatureAngle, bool);
  vtkBooleanMacro(PatchFromFeatureAngle, bool);
  ///@}

  ///@{
  /**
   * The angle in degrees, 0 to 180, for PatchFromFeatureAngle and SurfaceEdgeLength. Default 30.
   */
  vtkSetMacro(FeatureAngle, double);
  vtkGetMacro(FeatureAngle, double);
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

  /**
   * Sets the type of the patches that a pattern takes (a name, a name with the wildcards * and ?, or a
   * number): wall, symmetry, farfield, inlet, outlet, wake, interface or patch. Later calls win.
   */
  void SetPatchType(const char* pattern, const char* typeName);
  void ClearPatchTypes();

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

  int FillInputPortInformation(int port, vtkInformation* info) override;
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
  bool Repair = true;
  double WeldTolerance = -1;
  double ShortestEdge = -1;
  double LargestHole = 0;
  bool ImproveSurfaceTriangles = true;
  double MaximumSurfaceAngle = 10;
  double SurfaceGrowthRate = 1.3;
  double MaximumRadiusEdgeRatio = 1.4;
  double MinimumDihedralAngle = 10;
  bool FarField = false;
  double FarFieldMargins[6] = { 5, 5, 5, 5, 5, 5 };
  int FarFieldShape = BOX;
  int SymmetryPlane = NO_PLANE;
  double SymmetryPosition = 0;
  int WaterlinePlane = NO_PLANE;
  double WaterlinePosition = 0;
  int GroundPlane = NO_PLANE;
  double GroundPosition = 0;
  bool PatchFromFeatureAngle = false;
  double FeatureAngle = 30;
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
  // Adds what bounds the domain besides the surfaces.
  void DescribeDomain(ransmesh::MesherSettings& settings) const;
  // Reports why there is no mesh, and shows the triangles that are wrong. Gives RequestData's answer.
  int Refuse(const ransmesh::Outcome& outcome, const ransmesh::MesherReport& report, vtkPolyData* problems);
};

#endif

/**
 * @class   vtkDomainAlgorithm
 * @brief   holds what bounds a domain: surfaces and their repair, a far field, planes, sheets, and patches
 *
 * What vtkIsotropicTetMesher is to mesh; how it meshes that is its own. Lengths are in the unit of the surface.
 */
#ifndef vtkDomainAlgorithm_h
#define vtkDomainAlgorithm_h

#include "RANSMeshingTetGenModule.h"
#include "vtkUnstructuredGridAlgorithm.h"

#include <memory>

class vtkAlgorithmOutput;
class vtkDataObject;

namespace ransmesh
{
struct MesherSettings;
struct Outcome;
} // namespace ransmesh

class RANSMESHINGTETGEN_EXPORT vtkDomainAlgorithm : public vtkUnstructuredGridAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkDomainAlgorithm, vtkUnstructuredGridAlgorithm);
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
   * Points of open edges that lie within this distance of each other, in the unit of the surface, become one, and
   * those that lie within it of another open edge enter that edge. 0: none. Default -1: a millionth of the
   * largest extent.
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
   * Keeps what the patches that a pattern takes (a name, a name with the wildcards * and ?, or a number) enclose: the
   * inside of a body is meshed, as a region of its own (cell array RegionId), and its surface is faces of
   * the mesh with tetrahedra on both sides. All patches of the body must be taken. Unless their names or SetPatchType
   * tell otherwise they are of type patch: no walls, no layers. Default: insides of bodies are left empty.
   */
  void KeepInside(const char* pattern);
  void ClearKeptInsides();
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
   * Sets the type of the patches that a pattern takes (a name, a name with the wildcards * and ?, or a
   * number): wall, symmetry, farfield, inlet, outlet, wake, interface or patch. Later calls win.
   */
  void SetPatchType(const char* pattern, const char* typeName);
  void ClearPatchTypes();

protected:
  vtkDomainAlgorithm();
  ~vtkDomainAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  // BadInput names the option that is out of its range.
  ransmesh::Outcome CheckDomainOptions() const;
  // Puts into the settings what the options say of the domain.
  void DescribeDomain(ransmesh::MesherSettings& settings) const;

  bool Repair = true;
  double WeldTolerance = -1;
  double ShortestEdge = -1;
  double LargestHole = 0;
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

private:
  vtkDomainAlgorithm(const vtkDomainAlgorithm&) = delete;
  void operator=(const vtkDomainAlgorithm&) = delete;

  struct DomainInternals;
  std::unique_ptr<DomainInternals> DomainLists;
};

#endif

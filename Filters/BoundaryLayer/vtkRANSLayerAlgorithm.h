/**
 * @class   vtkRANSLayerAlgorithm
 * @brief   what the filters that make room for layers, and that make them, have in common
 *
 * Holds the layers' specification: which patches are viscous walls, and how the layers on them are to
 * be. Lengths are in the unit of the surface. What one filter of a chain was told, the next one uses
 * unless it is told otherwise: the specification travels in the field data. A filter whose FirstHeight
 * is 0 and that has no wall patches or patch layers of its own takes the specification that came with
 * its input, changed where its own parameters differ from their defaults.
 */
#ifndef vtkRANSLayerAlgorithm_h
#define vtkRANSLayerAlgorithm_h

#include "RANSMeshingBoundaryLayerModule.h"
#include "vtkUnstructuredGridAlgorithm.h"

#include <memory>
#include <vector>

class vtkDataArraySelection;
class vtkFieldData;
class vtkUnstructuredGrid;

namespace ransmesh
{
struct Context;
struct FlowConditions;
struct FlowEstimate;
struct MeshData;
struct Outcome;
struct LayerRequest;
struct LayerSpecification;
struct Patch;
} // namespace ransmesh

class RANSMESHINGBOUNDARYLAYER_EXPORT vtkRANSLayerAlgorithm : public vtkUnstructuredGridAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkRANSLayerAlgorithm, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Normal spacing of the first layer, h0 > 0, in the unit of the surface. Default 0: not given; it
   * must be given here, follow from flow conditions, or be given by SetPatchLayers or by an earlier filter of
   * the chain.
   */
  vtkSetMacro(FirstHeight, double);
  vtkGetMacro(FirstHeight, double);
  ///@}

  ///@{
  /**
   * Flow conditions in place of a first height: it follows from the y+ of the first point above the wall and
   * the friction on a flat plate at the reference length. Where Velocity or ReynoldsNumber is
   * given, FirstHeight has no effect. Solvers that store at cell centres see half the height.
   *
   * Velocity: of the outer flow, in m/s, > 0. Default 0: not given.
   * ReynoldsNumber: of the reference length, in place of velocity, fluid and length unit. Default 0: not given.
   * ReferenceLength: distance from the leading edge, in the unit of the surface. Default 0: must be given.
   * LengthUnit: metres in one unit of the surface. Default 1.
   * YPlus: > 0. Default 1.
   */
  vtkSetMacro(Velocity, double);
  vtkGetMacro(Velocity, double);
  vtkSetMacro(ReynoldsNumber, double);
  vtkGetMacro(ReynoldsNumber, double);
  vtkSetMacro(ReferenceLength, double);
  vtkGetMacro(ReferenceLength, double);
  vtkSetMacro(LengthUnit, double);
  vtkGetMacro(LengthUnit, double);
  vtkSetMacro(YPlus, double);
  vtkGetMacro(YPlus, double);
  ///@}

  enum FluidType
  {
    AIR,         ///< 1.225 kg/m3, 1.7894e-5 Pa s: 15 degrees C, 101 325 Pa (ISO 2533)
    WATER,       ///< 998.2 kg/m3, 1.0016e-3 Pa s: fresh, 20 degrees C
    CUSTOM_FLUID ///< Density and Viscosity as set
  };

  ///@{
  /**
   * The fluid that flows. Density (kg/m3) and Viscosity (dynamic, Pa s) are used for CUSTOM_FLUID only; their
   * defaults are those of air. Default AIR.
   */
  vtkSetClampMacro(Fluid, int, AIR, CUSTOM_FLUID);
  vtkGetMacro(Fluid, int);
  vtkSetMacro(Density, double);
  vtkGetMacro(Density, double);
  vtkSetMacro(Viscosity, double);
  vtkGetMacro(Viscosity, double);
  ///@}

  enum SkinFrictionLawType
  {
    SCHLICHTING,    ///< (2 log10 Re - 0.65)^-2.3; Re up to 1e9
    POWER_LAW,      ///< 0.0592 Re^-1/5; Re 5e5 to 1e7
    SCHULTZ_GRUNOW, ///< 0.370 (log10 Re)^-2.584; Re 1e6 to 1e9
    LAMINAR         ///< 0.664 Re^-1/2 (Blasius); Re up to 5e5
  };

  ///@{
  /**
   * Which correlation gives the local skin friction coefficient (Schlichting, Boundary-Layer Theory, chapter 21;
   * Blasius). Default SCHLICHTING.
   */
  vtkSetClampMacro(SkinFrictionLaw, int, SCHLICHTING, LAMINAR);
  vtkGetMacro(SkinFrictionLaw, int);
  ///@}

  ///@{
  /**
   * Whether the layers are to be as thick together as the boundary layer at the reference length,
   * 0.37 Re^-1/5 (laminar: 5 Re^-1/2) of it; needs flow conditions. Default off.
   */
  vtkSetMacro(ThicknessFromFlow, bool);
  vtkGetMacro(ThicknessFromFlow, bool);
  vtkBooleanMacro(ThicknessFromFlow, bool);
  ///@}

  ///@{
  /**
   * What follows from the flow conditions as they are set now; 0 where they are not given or impossible.
   * EstimatedFrictionVelocity is in m/s, or a fraction of the velocity where only the Reynolds number is given;
   * the lengths are in the unit of the surface.
   */
  double GetEstimatedReynoldsNumber() const;
  double GetEstimatedSkinFriction() const;
  double GetEstimatedFrictionVelocity() const;
  double GetEstimatedFirstHeight() const;
  double GetEstimatedBoundaryLayerThickness() const;
  ///@}

  ///@{
  /**
   * How many layers are asked for, and how thick they are together in the unit of the surface, where no patch
   * has layers of its own; 0 where no first height is given here.
   */
  int GetPlannedNumberOfLayers() const;
  double GetPlannedTotalThickness() const;
  ///@}

  ///@{
  /**
   * Ratio of successive spacings, 1 to 10. Default 1.2.
   */
  vtkSetMacro(GrowthRate, double);
  vtkGetMacro(GrowthRate, double);
  ///@}

  ///@{
  /**
   * Number of layers, 1 to 1000. Default 25.
   */
  vtkSetMacro(NumberOfLayers, int);
  vtkGetMacro(NumberOfLayers, int);
  ///@}

  ///@{
  /**
   * Thickness of all layers together, in the unit of the surface; the number of layers then follows.
   * Default 0: the thickness follows from the number of layers.
   */
  vtkSetMacro(TotalThickness, double);
  vtkGetMacro(TotalThickness, double);
  ///@}

  ///@{
  /**
   * Number of first layers that are all of the first height; the next ones grow. Default 0; 1 is the same.
   */
  vtkSetMacro(ConstantLayers, int);
  vtkGetMacro(ConstantLayers, int);
  ///@}

  ///@{
  /**
   * No point is placed where a level's spacing exceeds this times the local isotropic size (section 3
   * of Loehner's paper). Default 0.7.
   */
  vtkSetMacro(IsotropicFraction, double);
  vtkGetMacro(IsotropicFraction, double);
  ///@}

  ///@{
  /**
   * Wall faces that turn more than this at a point get normals of their own, in degrees, above 0, to 180.
   * Default 30.
   */
  vtkSetMacro(NormalAngle, double);
  vtkGetMacro(NormalAngle, double);
  ///@}

  ///@{
  /**
   * Largest angle between neighbouring columns of a fan, in degrees, 5 to 180. Default 30.
   */
  vtkSetMacro(FanAngle, double);
  vtkGetMacro(FanAngle, double);
  ///@}

  ///@{
  /**
   * Columns stop at this fraction of the distance to the opposite surface, 0 to 0.5. Default 0.3.
   */
  vtkSetMacro(GapFraction, double);
  vtkGetMacro(GapFraction, double);
  ///@}

  ///@{
  /**
   * No triangle of a patch that the layers run into may turn by more than this, in degrees, 0 to 90, when points are
   * removed or layers rise along it. Default 10.
   */
  vtkSetMacro(MaximumSurfaceAngle, double);
  vtkGetMacro(MaximumSurfaceAngle, double);
  ///@}

  ///@{
  /**
   * The viscous walls, by name, by name with the wildcards * and ?, or by number. A wildcard never
   * takes patches of type farfield, symmetry, inlet, outlet or interface: these must be named in full.
   * Without any, the walls are all patches of type wall or wake; if no types are known, every patch that is
   * not a side of the bounding box.
   */
  void AddWallPatch(const char* pattern);
  void ClearWallPatches();
  ///@}

  ///@{
  /**
   * The patches of the input, each chosen as a wall or not, for interfaces where they are ticked by name.
   * Filled in by UpdateInformation once the input is there, with the walls as they follow from the rules
   * above; what is changed then overrules them, patch by patch.
   */
  vtkDataArraySelection* GetWallPatchSelection();

  vtkMTimeType GetMTime() override;

  /**
   * Layers of their own for the patches that a pattern takes; these are walls then. Later calls win.
   */
  void SetPatchLayers(const char* pattern, double firstHeight, double growthRate, int numberOfLayers);
  void ClearPatchLayers();
  ///@}

protected:
  vtkRANSLayerAlgorithm();
  ~vtkRANSLayerAlgorithm() override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  /**
   * The specification of each patch, from the options or from the input's field data.
   */
  ransmesh::Outcome PlanLayers(const ransmesh::MeshData& mesh, const std::vector<ransmesh::Patch>& patches,
    vtkFieldData* recorded, std::vector<ransmesh::LayerSpecification>& plan);

  /**
   * What RequestData returns for an outcome that is no success, the outputs being left empty: 0, with an
   * error event; or 1, silently, when the user stopped it.
   */
  int Refuse(const ransmesh::Outcome& outcome);

  /**
   * Gives the output the regions that its tetrahedra are in now. Warns of regions that are no more.
   */
  void CarryRegions(const std::vector<int>& before, const std::vector<int>& now, vtkUnstructuredGrid* output);

  double FirstHeight;
  double Velocity;
  double ReynoldsNumber;
  double ReferenceLength;
  double LengthUnit;
  double YPlus;
  int Fluid;
  double Density;
  double Viscosity;
  int SkinFrictionLaw;
  bool ThicknessFromFlow;
  double GrowthRate;
  int NumberOfLayers;
  double TotalThickness;
  int ConstantLayers;
  double IsotropicFraction;
  double NormalAngle;
  double FanAngle;
  double GapFraction;
  double MaximumSurfaceAngle;

private:
  vtkRANSLayerAlgorithm(const vtkRANSLayerAlgorithm&) = delete;
  void operator=(const vtkRANSLayerAlgorithm&) = delete;

  bool UsesRecordedPlan() const;
  ransmesh::FlowConditions Flow() const;
  ransmesh::FlowEstimate Estimate() const;
  ransmesh::Outcome CheckFlow();
  ransmesh::LayerRequest MakeRequest() const;
  ransmesh::Outcome AdaptRecorded(
    const std::vector<ransmesh::Patch>& patches, std::vector<ransmesh::LayerSpecification>& plan) const;
  void OverrideRecorded(ransmesh::LayerSpecification& specification) const;

  struct Internals;
  std::unique_ptr<Internals> Rules;
};

#endif

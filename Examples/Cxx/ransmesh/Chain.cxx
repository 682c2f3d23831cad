#include "Chain.h"

#include <vtkDirectionalEnrichment.h>
#include <vtkIsotropicTetMesher.h>
#include <vtkMeshAdoption.h>
#include <vtkMeshQualityReport.h>
#include <vtkPolyData.h>
#include <vtkPrismRecombination.h>
#include <vtkRANSPointRemoval.h>
#include <vtkSurfaceWrap.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <string_view>

namespace commandline
{
namespace
{
std::array<double, 6> marginsOf(const Options& options)
{
  static constexpr std::array<std::string_view, 6> sides = { "xmin", "xmax", "ymin", "ymax", "zmin", "zmax" };
  std::array<double, 6> margins{};
  margins.fill(options.farField);
  for (const MarginOption& margin : options.margins)
  {
    margins[std::find(sides.begin(), sides.end(), margin.side) - sides.begin()] = margin.margin;
  }
  return margins;
}
} // namespace

Chain::Chain(const Options& options, vtkDataObject* input, vtkPolyData* sheets)
  : options_(options)
{
  progress_->setQuiet(options.quiet);
  if (options.repair.wrapAlpha > 0)
  {
    wrap_->SetInputDataObject(0, input);
    mesher_->SetInputConnection(wrap_->GetOutputPort());
  }
  else
  {
    isotropicMesh()->SetInputDataObject(0, input);
  }
  if (sheets)
  {
    mesher_->AddSheetData(sheets);
  }
  describeSurfaces();
  describeRepair();
  describePatches();
  describeDomain();
  removal_->SetInputConnection(isotropicMesh()->GetOutputPort());
  describeLayers();
  // The enrichment takes the layers that the removal made room for: they travel with the mesh.
  enrichment_->SetInputConnection(removal_->GetOutputPort());
  // Each mesh goes when the next one is made: that halves the memory.
  isotropicMesh()->ReleaseDataFlagOn();
  removal_->ReleaseDataFlagOn();
  if (options.isotropicOnly)
  {
    report_->SetInputConnection(isotropicMesh()->GetOutputPort());
    return;
  }
  recombination_->SetInputConnection(enrichment_->GetOutputPort());
  vtkAlgorithm* last = options.prisms ? recombination_.Get() : static_cast<vtkAlgorithm*>(enrichment_.Get());
  report_->SetInputConnection(0, last->GetOutputPort(0));
  report_->SetInputConnection(1, enrichment_->GetOutputPort(1)); // why columns stopped
}

Chain::~Chain() = default;

vtkAlgorithm* Chain::isotropicMesh() const
{
  return options_.isMesh() ? adoption_.Get() : static_cast<vtkAlgorithm*>(mesher_.Get());
}

void Chain::describeSurfaces()
{
  const RemeshOptions& remesh = options_.remesh;
  mesher_->SetSurfaceEdgeLength(remesh.length);
  for (const auto& [patch, length] : remesh.ofPatch)
  {
    mesher_->SetPatchEdgeLength(patch.c_str(), length);
  }
  mesher_->SetEdgesPerCircle(remesh.edgesPerCircle);
  mesher_->SetEdgesAcrossGap(remesh.edgesAcrossGap);
  mesher_->SetSmallestSurfaceEdgeLength(remesh.smallest);
  mesher_->SetMaximumSurfaceDeviation(remesh.deviation);
  mesher_->SetSurfaceSizeArray(remesh.array.c_str());
  if (options_.swapAngle >= 0)
  {
    mesher_->SetImproveSurfaceTriangles(options_.swapAngle > 0);
    mesher_->SetMaximumSurfaceAngle(options_.swapAngle);
  }
}

void Chain::describeRepair()
{
  const RepairOptions& repair = options_.repair;
  wrap_->SetAlpha(repair.wrapAlpha);
  wrap_->SetOffset(repair.wrapOffset);
  mesher_->SetRepair(repair.repair);
  mesher_->SetWeldTolerance(repair.weld);
  mesher_->SetShortestEdge(repair.shortestEdge);
  mesher_->SetLargestHole(repair.largestHole);
  mesher_->SetWorkerTimeLimit(options_.timeLimit);
  mesher_->SetWorkerMemoryLimit(options_.memoryLimit);
}

// Of surfaces, or of a mesh that is there.
void Chain::describePatches()
{
  for (const auto& [pattern, type] : options_.typesOfPatterns)
  {
    mesher_->SetPatchType(pattern.c_str(), type.c_str());
    adoption_->SetPatchType(pattern.c_str(), type.c_str());
  }
  if (options_.featureAngle >= 0)
  {
    mesher_->SetFeatureAngle(options_.featureAngle);
    adoption_->SetFeatureAngle(options_.featureAngle);
  }
}

void Chain::describeDomain()
{
  if (options_.radiusEdgeRatio > 0)
  {
    mesher_->SetMaximumRadiusEdgeRatio(options_.radiusEdgeRatio);
  }
  if (options_.dihedralAngle >= 0)
  {
    mesher_->SetMinimumDihedralAngle(options_.dihedralAngle);
  }
  mesher_->SetMaximumEdgeLength(options_.size);
  if (options_.sizeGrowth > 0)
  {
    mesher_->SetSurfaceGrowthRate(options_.sizeGrowth);
  }
  for (const auto& b : options_.refine.boxes)
  {
    mesher_->AddRefinementBox(b[0], b[1], b[2], b[3], b[4], b[5], b[6]);
  }
  for (const auto& s : options_.refine.spheres)
  {
    mesher_->AddRefinementSphere(s[0], s[1], s[2], s[3], s[4]);
  }
  for (const auto& l : options_.refine.lines)
  {
    mesher_->AddRefinementLine(l[0], l[1], l[2], l[3], l[4], l[5], l[6], l[7]);
  }
  if (options_.farField > 0)
  {
    mesher_->FarFieldOn();
    mesher_->SetFarFieldMargins(marginsOf(options_).data());
    mesher_->SetFarFieldShape(options_.sphere ? vtkIsotropicTetMesher::SPHERE : vtkIsotropicTetMesher::BOX);
  }
  for (const SideOption& side : options_.sides)
  {
    mesher_->SetFarFieldSide(side.side.c_str(), side.name.c_str(), side.type.c_str());
  }
  describePlanes();
  for (const std::string& pattern : options_.keptInsides)
  {
    mesher_->KeepInside(pattern.c_str());
  }
}

void Chain::describePlanes()
{
  mesher_->SetSymmetryPlane(options_.symmetry.axis);
  mesher_->SetSymmetryPosition(options_.symmetry.place);
  mesher_->SetWaterlinePlane(options_.waterline.axis);
  mesher_->SetWaterlinePosition(options_.waterline.place);
  mesher_->SetGroundPlane(options_.ground.axis);
  mesher_->SetGroundPosition(options_.ground.place);
}

void Chain::describeFlow()
{
  const FlowOptions& flow = options_.flow;
  removal_->SetVelocity(flow.velocity);
  removal_->SetReynoldsNumber(flow.reynoldsNumber);
  removal_->SetReferenceLength(flow.length);
  removal_->SetFluid(fluidOf(flow));
  removal_->SetSkinFrictionLaw(frictionLawOf(flow));
  removal_->SetThicknessFromFlow(flow.givesThickness);
  if (flow.density > 0)
  {
    removal_->SetDensity(flow.density);
    removal_->SetViscosity(flow.viscosity);
  }
  if (flow.lengthUnit > 0)
  {
    removal_->SetLengthUnit(flow.lengthUnit);
  }
  if (flow.yPlus > 0)
  {
    removal_->SetYPlus(flow.yPlus);
  }
}

void Chain::describeLayers()
{
  removal_->SetFirstHeight(options_.firstHeight);
  describeFlow();
  describeColumns();
  if (options_.growth > 0)
  {
    removal_->SetGrowthRate(options_.growth);
  }
  if (options_.layers > 0)
  {
    removal_->SetNumberOfLayers(options_.layers);
  }
  if (options_.thickness > 0)
  {
    removal_->SetTotalThickness(options_.thickness);
  }
  for (const std::string& pattern : options_.walls)
  {
    removal_->AddWallPatch(pattern.c_str());
  }
  for (const PatchLayersOption& layers : options_.patchLayers)
  {
    removal_->SetPatchLayers(layers.pattern.c_str(), layers.firstHeight,
      layers.growth > 0 ? layers.growth : removal_->GetGrowthRate(),
      layers.layers > 0 ? layers.layers : removal_->GetNumberOfLayers());
  }
}

void Chain::describeColumns()
{
  const ColumnOptions& columns = options_.columns;
  removal_->SetConstantLayers(columns.constantLayers);
  if (columns.isotropicFraction > 0)
  {
    removal_->SetIsotropicFraction(columns.isotropicFraction);
  }
  if (columns.normalAngle > 0)
  {
    removal_->SetNormalAngle(columns.normalAngle);
  }
  if (columns.fanAngle > 0)
  {
    removal_->SetFanAngle(columns.fanAngle);
  }
  // These two do not travel with the mesh.
  if (columns.gapFraction > 0)
  {
    enrichment_->SetGapFraction(columns.gapFraction);
  }
  if (columns.surfaceAngle >= 0)
  {
    removal_->SetMaximumSurfaceAngle(columns.surfaceAngle);
    enrichment_->SetMaximumSurfaceAngle(columns.surfaceAngle);
  }
  if (options_.nonOrthogonality >= 0)
  {
    recombination_->SetMaximumNonOrthogonality(options_.nonOrthogonality);
  }
}

void Chain::runStage(const std::string& name, vtkAlgorithm* filter)
{
  messages_->watch(filter);
  progress_->watch(filter, name);
  const auto start = std::chrono::steady_clock::now();
  filter->Update();
  progress_->clear();
  if (!messages_->errors().empty())
  {
    throw MeshingError(name + ": " + messages_->errors().front());
  }
  if (vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfCells() == 0)
  {
    throw MeshingError(name + ": stopped on request");
  }
  times_.push_back({ name, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() });
}

void Chain::run()
{
  if (options_.repair.wrapAlpha > 0)
  {
    runStage("wrapping", wrap_);
  }
  runStage("isotropic mesh", isotropicMesh());
  if (!options_.isotropicOnly)
  {
    runStage("removal of points", removal_);
    runStage("enrichment", enrichment_);
  }
  if (options_.prisms)
  {
    runStage("recombination to prisms", recombination_);
  }
  runStage("quality report", report_);
  if (!report_->GetValid())
  {
    throw MeshingError(
      "the mesh that came out is not valid; this is a fault of the program, not of the surface");
  }
}

vtkUnstructuredGrid* Chain::mesh() const
{
  return vtkUnstructuredGrid::SafeDownCast(report_->GetOutputDataObject(0));
}

vtkRANSLayerAlgorithm* Chain::layers() const
{
  return removal_;
}

vtkMeshQualityReport* Chain::report() const
{
  return report_;
}

vtkPolyData* Chain::problems() const
{
  return vtkPolyData::SafeDownCast(mesher_->GetOutputDataObject(1));
}
} // namespace commandline

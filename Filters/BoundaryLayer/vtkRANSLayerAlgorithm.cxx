#include "vtkRANSLayerAlgorithm.h"

#include "Layers/FlowConditions.h"
#include "Layers/LayerPlanning.h"
#include "MeshConversion.h"
#include "RegionArrays.h"
#include "Support/Numbers.h"
#include "WallSelection.h"

#include "vtkDataArraySelection.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

struct vtkRANSLayerAlgorithm::Internals
{
  std::vector<std::string> WallPatterns;
  std::vector<ransmesh::PatchLayers> PatchLayers;
  ransmesh::WallSelection Walls;
};

vtkRANSLayerAlgorithm::vtkRANSLayerAlgorithm()
  : FirstHeight(0)
  , Velocity(0)
  , ReynoldsNumber(0)
  , ReferenceLength(0)
  , LengthUnit(1)
  , YPlus(ransmesh::defaults::yPlus)
  , Fluid(AIR)
  , Density(ransmesh::fluids::air.density)
  , Viscosity(ransmesh::fluids::air.viscosity)
  , SkinFrictionLaw(SCHLICHTING)
  , ThicknessFromFlow(false)
  , GrowthRate(ransmesh::defaults::growthRate)
  , NumberOfLayers(ransmesh::defaults::numberOfLayers)
  , TotalThickness(0)
  , ConstantLayers(ransmesh::defaults::constantLayers)
  , IsotropicFraction(ransmesh::defaults::isotropicFraction)
  , NormalAngle(ransmesh::defaults::normalAngle)
  , FanAngle(ransmesh::defaults::fanAngle)
  , GapFraction(ransmesh::defaults::gapFraction)
  , MaximumSurfaceAngle(ransmesh::defaults::maximumSurfaceAngle)
  , Rules(std::make_unique<Internals>())
{
}

vtkRANSLayerAlgorithm::~vtkRANSLayerAlgorithm() = default;

void vtkRANSLayerAlgorithm::AddWallPatch(const char* pattern)
{
  if (pattern && *pattern)
  {
    this->Rules->WallPatterns.emplace_back(pattern);
    this->Modified();
  }
}

void vtkRANSLayerAlgorithm::ClearWallPatches()
{
  this->Rules->WallPatterns.clear();
  this->Modified();
}

void vtkRANSLayerAlgorithm::SetPatchLayers(
  const char* pattern, double firstHeight, double growthRate, int numberOfLayers)
{
  if (pattern && *pattern)
  {
    this->Rules->PatchLayers.push_back({ pattern, firstHeight, growthRate, numberOfLayers });
    this->Modified();
  }
}

void vtkRANSLayerAlgorithm::ClearPatchLayers()
{
  this->Rules->PatchLayers.clear();
  this->Modified();
}

vtkDataArraySelection* vtkRANSLayerAlgorithm::GetWallPatchSelection()
{
  return this->Rules->Walls.selection();
}

vtkMTimeType vtkRANSLayerAlgorithm::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Rules->Walls.selection()->GetMTime());
}

bool vtkRANSLayerAlgorithm::UsesRecordedPlan() const
{
  return this->FirstHeight == 0 && !this->Flow().areGiven() && this->Rules->WallPatterns.empty() &&
    this->Rules->PatchLayers.empty();
}

void vtkRANSLayerAlgorithm::OverrideRecorded(ransmesh::LayerSpecification& s) const
{
  const auto override = [](auto& recorded, auto own, auto byDefault)
  {
    if (own != byDefault)
    {
      recorded = own;
    }
  };
  override(s.growthRate, this->GrowthRate, ransmesh::defaults::growthRate);
  override(s.numberOfLayers, this->NumberOfLayers, ransmesh::defaults::numberOfLayers);
  override(s.constantLayers, this->ConstantLayers, ransmesh::defaults::constantLayers);
  override(s.isotropicFraction, this->IsotropicFraction, ransmesh::defaults::isotropicFraction);
  override(s.normalAngle, this->NormalAngle, ransmesh::defaults::normalAngle);
  override(s.fanAngle, this->FanAngle, ransmesh::defaults::fanAngle);
  if (this->TotalThickness > 0)
  {
    s.numberOfLayers = ransmesh::layersForThickness(s, this->TotalThickness);
  }
}

ransmesh::Outcome vtkRANSLayerAlgorithm::AdaptRecorded(
  const ransmesh::PatchTable& patches, ransmesh::LayerPlan& plan) const
{
  this->Rules->Walls.applyTo(patches, plan);
  for (std::size_t i = 1; i < plan.size(); ++i)
  {
    if (plan[i].hasLayers())
    {
      this->OverrideRecorded(plan[i]);
      if (auto outcome = ransmesh::checkSpecification(plan[i], patches[i].name.c_str()); !outcome.ok())
      {
        return outcome;
      }
    }
  }
  return ransmesh::Outcome::done();
}

ransmesh::FlowConditions vtkRANSLayerAlgorithm::Flow() const
{
  ransmesh::FlowConditions flow;
  flow.velocity = this->Velocity;
  flow.reynoldsNumber = this->ReynoldsNumber;
  flow.referenceLength = this->ReferenceLength;
  flow.lengthUnit = this->LengthUnit;
  flow.yPlus = this->YPlus;
  flow.law = static_cast<ransmesh::SkinFrictionLaw>(this->SkinFrictionLaw);
  flow.fluid = this->Fluid == AIR ? ransmesh::fluids::air
    : this->Fluid == WATER        ? ransmesh::fluids::water
                                  : ransmesh::Fluid{ this->Density, this->Viscosity };
  return flow;
}

ransmesh::FlowEstimate vtkRANSLayerAlgorithm::Estimate() const
{
  ransmesh::FlowEstimate estimate;
  ransmesh::estimateFlow(this->Flow(), estimate); // its errors are told by CheckFlow
  return estimate;
}

double vtkRANSLayerAlgorithm::GetEstimatedReynoldsNumber() const
{
  return this->Estimate().reynoldsNumber;
}

double vtkRANSLayerAlgorithm::GetEstimatedSkinFriction() const
{
  return this->Estimate().skinFriction;
}

double vtkRANSLayerAlgorithm::GetEstimatedFrictionVelocity() const
{
  return this->Estimate().frictionVelocity;
}

double vtkRANSLayerAlgorithm::GetEstimatedFirstHeight() const
{
  return this->Estimate().firstHeight;
}

double vtkRANSLayerAlgorithm::GetEstimatedBoundaryLayerThickness() const
{
  return this->Estimate().thickness;
}

int vtkRANSLayerAlgorithm::GetPlannedNumberOfLayers() const
{
  const ransmesh::LayerSpecification general = ransmesh::generalSpecification(this->MakeRequest());
  return ransmesh::checkSpecification(general, "").ok() ? general.numberOfLayers : 0;
}

double vtkRANSLayerAlgorithm::GetPlannedTotalThickness() const
{
  const ransmesh::LayerSpecification general = ransmesh::generalSpecification(this->MakeRequest());
  return ransmesh::checkSpecification(general, "").ok() ? ransmesh::LayerHeights(general).thickness() : 0;
}

ransmesh::Outcome vtkRANSLayerAlgorithm::CheckFlow()
{
  const ransmesh::FlowConditions flow = this->Flow();
  if (!flow.areGiven())
  {
    return this->ThicknessFromFlow
      ? ransmesh::Outcome::badInput("ThicknessFromFlow needs flow conditions: set Velocity or ReynoldsNumber")
      : ransmesh::Outcome::done();
  }
  ransmesh::FlowEstimate estimate;
  const ransmesh::Outcome outcome = ransmesh::estimateFlow(flow, estimate);
  if (outcome.ok() && !estimate.isWithinRange)
  {
    vtkWarningMacro(<< "the Reynolds number " << estimate.reynoldsNumber
                    << " is outside the range that the law of " << ransmesh::nameOf(flow.law)
                    << " was made for: the first height is a rough guess");
  }
  return outcome;
}

ransmesh::LayerRequest vtkRANSLayerAlgorithm::MakeRequest() const
{
  const ransmesh::FlowEstimate estimate = this->Estimate();
  ransmesh::LayerRequest request;
  request.general.firstHeight = this->Flow().areGiven() ? estimate.firstHeight : this->FirstHeight;
  request.general.growthRate = this->GrowthRate;
  request.general.numberOfLayers = this->NumberOfLayers;
  request.general.constantLayers = this->ConstantLayers;
  request.general.isotropicFraction = this->IsotropicFraction;
  request.general.normalAngle = this->NormalAngle;
  request.general.fanAngle = this->FanAngle;
  request.totalThickness = this->ThicknessFromFlow ? estimate.thickness : this->TotalThickness;
  request.wallPatterns = this->Rules->WallPatterns;
  request.patchLayers = this->Rules->PatchLayers;
  request.choices = this->Rules->Walls.choices();
  return request;
}

int vtkRANSLayerAlgorithm::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (auto* grid = vtkUnstructuredGrid::GetData(inputVector[0]))
  {
    ransmesh::LayerRequest rules = this->MakeRequest();
    rules.choices.clear();
    this->Rules->Walls.offer(grid, rules, this->UsesRecordedPlan());
  }
  return this->Superclass::RequestInformation(request, inputVector, outputVector);
}

ransmesh::Outcome vtkRANSLayerAlgorithm::PlanLayers(const ransmesh::MeshData& mesh,
  const std::vector<ransmesh::Patch>& patches, vtkFieldData* recorded,
  std::vector<ransmesh::LayerSpecification>& plan)
{
  if (auto outcome = this->CheckFlow(); !outcome.ok())
  {
    return outcome;
  }
  if (!(this->TotalThickness >= 0) || !std::isfinite(this->TotalThickness))
  {
    return ransmesh::Outcome::badInput("the total thickness is " + ransmesh::textOf(this->TotalThickness) +
      "; it must be positive, or 0 where NumberOfLayers counts: set TotalThickness");
  }
  const ransmesh::LayerPlan before =
    this->UsesRecordedPlan() ? ransmesh::readPlan(recorded) : ransmesh::LayerPlan();
  const bool isRecorded = before.size() == patches.size();
  std::vector<char> walls = ransmesh::wallsOf(before);
  ransmesh::LayerRequest request = this->MakeRequest();
  if (isRecorded)
  {
    plan = before;
  }
  else
  {
    ransmesh::LayerRequest rules = request;
    rules.choices.clear();
    ransmesh::findWalls(mesh, patches, rules, walls); // its errors come again from planLayers
  }
  ransmesh::Outcome outcome =
    isRecorded ? this->AdaptRecorded(patches, plan) : ransmesh::planLayers(mesh, patches, request, plan);
  this->Rules->Walls.offer(patches, walls);
  return outcome;
}

void vtkRANSLayerAlgorithm::CarryRegions(
  const std::vector<int>& before, const std::vector<int>& now, vtkUnstructuredGrid* output)
{
  ransmesh::writeRegions(now, output);
  if (const std::string lost = ransmesh::lostRegions(before, now); !lost.empty())
  {
    vtkWarningMacro(<< lost);
  }
}

int vtkRANSLayerAlgorithm::Refuse(const ransmesh::Outcome& outcome)
{
  if (outcome.kind == ransmesh::Outcome::Kind::Cancelled)
  {
    return 1;
  }
  vtkErrorMacro(<< outcome.message);
  return 0;
}

void vtkRANSLayerAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FirstHeight: " << this->FirstHeight << "\n";
  os << indent << "Velocity: " << this->Velocity << "\n";
  os << indent << "ReynoldsNumber: " << this->ReynoldsNumber << "\n";
  os << indent << "ReferenceLength: " << this->ReferenceLength << "\n";
  os << indent << "LengthUnit: " << this->LengthUnit << "\n";
  os << indent << "YPlus: " << this->YPlus << "\n";
  os << indent << "Fluid: " << this->Fluid << "\n";
  os << indent << "Density: " << this->Density << "\n";
  os << indent << "Viscosity: " << this->Viscosity << "\n";
  os << indent << "SkinFrictionLaw: " << this->SkinFrictionLaw << "\n";
  os << indent << "ThicknessFromFlow: " << this->ThicknessFromFlow << "\n";
  os << indent << "GrowthRate: " << this->GrowthRate << "\n";
  os << indent << "NumberOfLayers: " << this->NumberOfLayers << "\n";
  os << indent << "TotalThickness: " << this->TotalThickness << "\n";
  os << indent << "ConstantLayers: " << this->ConstantLayers << "\n";
  os << indent << "IsotropicFraction: " << this->IsotropicFraction << "\n";
  os << indent << "NormalAngle: " << this->NormalAngle << "\n";
  os << indent << "FanAngle: " << this->FanAngle << "\n";
  os << indent << "GapFraction: " << this->GapFraction << "\n";
  os << indent << "MaximumSurfaceAngle: " << this->MaximumSurfaceAngle << "\n";
  for (const std::string& pattern : this->Rules->WallPatterns)
  {
    os << indent << "WallPatch: " << pattern << "\n";
  }
  for (const auto& rule : this->Rules->PatchLayers)
  {
    os << indent << "PatchLayers: " << rule.pattern << " " << rule.firstHeight << " " << rule.growthRate
       << " " << rule.numberOfLayers << "\n";
  }
}

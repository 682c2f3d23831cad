#include "vtkSurfaceRemesher.h"

#include "OptionRange.h"
#include "StageContext.h"
#include "SurfaceFilterInput.h"
#include "SurfaceOutput.h"
#include "SurfaceSizing.h"

#include "Surface/Preparation.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkSurfaceRemesher);

struct vtkSurfaceRemesher::Internals
{
  std::vector<std::pair<std::string, double>> LengthOfPattern;
};

//------------------------------------------------------------------------------
vtkSurfaceRemesher::vtkSurfaceRemesher()
  : Lists(new Internals)
{
}

//------------------------------------------------------------------------------
vtkSurfaceRemesher::~vtkSurfaceRemesher()
{
  this->SetSizeArray(nullptr);
}

//------------------------------------------------------------------------------
void vtkSurfaceRemesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "EdgeLength: " << this->EdgeLength << "\n";
  os << indent << "Patch edge lengths: " << this->Lists->LengthOfPattern.size() << "\n";
  os << indent << "EdgesPerCircle: " << this->EdgesPerCircle << "\n";
  os << indent << "EdgesAcrossGap: " << this->EdgesAcrossGap << "\n";
  os << indent << "GapSide: " << this->GapSide << "\n";
  os << indent << "SmallestEdgeLength: " << this->SmallestEdgeLength << "\n";
  os << indent << "GrowthRate: " << this->GrowthRate << "\n";
  os << indent << "MaximumDeviation: " << this->MaximumDeviation << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "SizeArray: " << (this->SizeArray ? this->SizeArray : "") << "\n";
  os << indent << "Deviation: " << this->Deviation << "\n";
  os << indent << "LowAngle: " << this->LowAngle << "\n";
}

//------------------------------------------------------------------------------
void vtkSurfaceRemesher::SetPatchEdgeLength(const char* pattern, double length)
{
  if (pattern && length > 0)
  {
    this->Lists->LengthOfPattern.emplace_back(pattern, length);
    this->Modified();
    return;
  }
  vtkErrorMacro("SetPatchEdgeLength needs the name of a patch and a length above 0.");
}

//------------------------------------------------------------------------------
void vtkSurfaceRemesher::ClearPatchEdgeLengths()
{
  this->Lists->LengthOfPattern.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkSurfaceRemesher::FillInputPortInformation(int, vtkInformation* info)
{
  ransmesh::acceptSurfaces(info);
  return 1;
}

//------------------------------------------------------------------------------
bool vtkSurfaceRemesher::OptionsAreValid()
{
  constexpr double largest = ransmesh::LargestLength;
  const ransmesh::Outcome outcome = ransmesh::checkRanges({ { "EdgeLength", this->EdgeLength, 0, largest },
    { "EdgesPerCircle", this->EdgesPerCircle, 0, 1e4 }, { "EdgesAcrossGap", this->EdgesAcrossGap, 0, 1e3 },
    { "SmallestEdgeLength", this->SmallestEdgeLength, 0, largest },
    { "GrowthRate", this->GrowthRate, 1.01, 3 }, { "MaximumDeviation", this->MaximumDeviation, 0, largest },
    { "FeatureAngle", this->FeatureAngle, 0, 180 } });
  if (!outcome.ok())
  {
    vtkErrorMacro(<< outcome.message << ".");
  }
  return outcome.ok();
}

//------------------------------------------------------------------------------
int vtkSurfaceRemesher::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!this->OptionsAreValid())
  {
    return 0;
  }
  ransmesh::SurfaceSizing sizing;
  sizing.general.length = this->EdgeLength;
  sizing.general.edgesPerCircle = this->EdgesPerCircle;
  sizing.general.edgesAcrossGap = this->EdgesAcrossGap;
  sizing.general.gapSide = static_cast<ransmesh::GapSide>(this->GapSide);
  sizing.general.smallest = this->SmallestEdgeLength;
  sizing.general.slope = this->GrowthRate - 1;
  sizing.general.deviation = this->MaximumDeviation;
  sizing.general.featureAngle = this->FeatureAngle;
  sizing.lengthOfPattern = this->Lists->LengthOfPattern;

  ransmesh::SurfaceInput input;
  ransmesh::Outcome outcome = ransmesh::readSurfaces(inputVector[0], input);
  if (outcome.ok())
  {
    outcome = ransmesh::checkCoordinates(input.surface, "surface");
  }
  if (outcome.ok() && this->SizeArray && *this->SizeArray)
  {
    outcome = ransmesh::readLengthsAtPoints(ransmesh::dataOf(inputVector[0]), this->SizeArray, sizing);
  }
  ransmesh::RemeshingOptions options;
  ransmesh::RemeshingReport report;
  if (outcome.ok())
  {
    // What would be two borders side by side must be one edge first.
    ransmesh::repairSurface(input.surface, input.patches, {});
    outcome = ransmesh::remeshingOptions(sizing, input.patches, input.surface, options);
  }
  if (outcome.ok())
  {
    outcome = ransmesh::remeshSurface(input.surface, options, report, ransmesh::makeContext(this));
  }
  if (outcome.kind == ransmesh::Outcome::Kind::Cancelled)
  {
    return 1; // as the user wished: an empty surface, no error
  }
  if (!outcome.ok())
  {
    vtkErrorMacro(<< "Cannot remesh: " << outcome.message << ".");
    return 0;
  }
  this->Deviation = report.largestDeviation;
  this->LowAngle = report.lowAngle;
  vtkWarningMacro(<< ransmesh::textOf(report));
  ransmesh::writeSurface(input.surface, input.patches, vtkPolyData::GetData(outputVector, 0));
  return 1;
}

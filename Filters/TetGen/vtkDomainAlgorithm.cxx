#include "vtkDomainAlgorithm.h"

#include "MesherSettings.h"

#include "OptionRange.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

struct vtkDomainAlgorithm::DomainInternals
{
  std::vector<std::pair<std::string, std::string>> TypeOfPattern;
  std::array<std::optional<ransmesh::SideName>, 6> Sides;
  std::vector<std::string> KeptInsides;
};

//------------------------------------------------------------------------------
vtkDomainAlgorithm::vtkDomainAlgorithm()
  : DomainLists(new DomainInternals)
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkDomainAlgorithm::~vtkDomainAlgorithm() = default;

//------------------------------------------------------------------------------
void vtkDomainAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Repair: " << this->Repair << "\n";
  os << indent << "WeldTolerance: " << this->WeldTolerance << "\n";
  os << indent << "ShortestEdge: " << this->ShortestEdge << "\n";
  os << indent << "LargestHole: " << this->LargestHole << "\n";
  os << indent << "FarField: " << this->FarField << "\n";
  os << indent << "FarFieldMargins:";
  for (const double margin : this->FarFieldMargins)
  {
    os << " " << margin;
  }
  os << "\n";
  os << indent << "FarFieldShape: " << this->FarFieldShape << "\n";
  os << indent << "SymmetryPlane: " << this->SymmetryPlane << "\n";
  os << indent << "SymmetryPosition: " << this->SymmetryPosition << "\n";
  os << indent << "WaterlinePlane: " << this->WaterlinePlane << "\n";
  os << indent << "WaterlinePosition: " << this->WaterlinePosition << "\n";
  os << indent << "GroundPlane: " << this->GroundPlane << "\n";
  os << indent << "GroundPosition: " << this->GroundPosition << "\n";
  os << indent << "PatchFromFeatureAngle: " << this->PatchFromFeatureAngle << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "Patches whose insides are kept: " << this->DomainLists->KeptInsides.size() << "\n";
  os << indent << "Patch types set: " << this->DomainLists->TypeOfPattern.size() << "\n";
}

//------------------------------------------------------------------------------
void vtkDomainAlgorithm::SetPatchType(const char* pattern, const char* typeName)
{
  if (pattern && typeName)
  {
    this->DomainLists->TypeOfPattern.emplace_back(pattern, typeName);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkDomainAlgorithm::ClearPatchTypes()
{
  this->DomainLists->TypeOfPattern.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkDomainAlgorithm::KeepInside(const char* pattern)
{
  if (pattern)
  {
    this->DomainLists->KeptInsides.emplace_back(pattern);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkDomainAlgorithm::ClearKeptInsides()
{
  this->DomainLists->KeptInsides.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkDomainAlgorithm::SetFarFieldSide(const char* side, const char* name, const char* type)
{
  const auto& known = ransmesh::SideNames;
  const auto found = std::find(known.begin(), known.end(), std::string(side ? side : ""));
  if (found == known.end() || !name || !*name)
  {
    vtkErrorMacro("SetFarFieldSide needs a side (xmin, xmax, ymin, ymax, zmin or zmax) and a name.");
    return;
  }
  this->DomainLists->Sides[found - known.begin()] = { name, type ? type : "" };
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkDomainAlgorithm::ClearFarFieldSides()
{
  this->DomainLists->Sides = {};
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkDomainAlgorithm::AddSheetData(vtkDataObject* sheets)
{
  this->AddInputDataObject(1, sheets);
}

//------------------------------------------------------------------------------
void vtkDomainAlgorithm::AddSheetConnection(vtkAlgorithmOutput* sheets)
{
  this->AddInputConnection(1, sheets);
}

//------------------------------------------------------------------------------
void vtkDomainAlgorithm::RemoveAllSheets()
{
  this->SetInputConnection(1, nullptr);
}

//------------------------------------------------------------------------------
int vtkDomainAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 1);
  return 1;
}

//------------------------------------------------------------------------------
ransmesh::Outcome vtkDomainAlgorithm::CheckDomainOptions() const
{
  constexpr double largest = ransmesh::LargestLength;
  std::vector<ransmesh::OptionRange> ranges = { { "FeatureAngle", this->FeatureAngle, 0, 180 },
    { "SymmetryPosition", this->SymmetryPosition, -largest, largest },
    { "WaterlinePosition", this->WaterlinePosition, -largest, largest },
    { "GroundPosition", this->GroundPosition, -largest, largest },
    { "WeldTolerance", this->WeldTolerance, -1, largest },
    { "ShortestEdge", this->ShortestEdge, -1, largest }, { "LargestHole", this->LargestHole, 0, largest } };
  for (int i = 0; this->FarField && i < 6; ++i)
  {
    ranges.push_back({ "FarFieldMargins", this->FarFieldMargins[i], 1e-3, 1e4 });
  }
  return ransmesh::checkRanges(ranges);
}

//------------------------------------------------------------------------------
void vtkDomainAlgorithm::DescribeDomain(ransmesh::MesherSettings& settings) const
{
  settings.preparation.repair = this->Repair;
  settings.preparation.repairs = { this->WeldTolerance, this->ShortestEdge, this->LargestHole };
  settings.patchFromFeatureAngle = this->PatchFromFeatureAngle;
  settings.featureAngle = this->FeatureAngle;
  settings.typeOfPattern = this->DomainLists->TypeOfPattern;
  settings.keptInsides = this->DomainLists->KeptInsides;
  if (this->FarField)
  {
    ransmesh::FarFieldOptions& farField = settings.farField.emplace();
    farField.isSphere = this->FarFieldShape == SPHERE;
    std::copy_n(this->FarFieldMargins, 6, farField.margins.begin());
    farField.sides = this->DomainLists->Sides;
  }
  using Keep = ransmesh::DomainPlane::Keep;
  const auto add = [&](int axis, double place, Keep keep, const char* purpose, const ransmesh::Patch& patch)
  {
    if (axis != NO_PLANE)
    {
      settings.planes.push_back({ purpose, { axis - 1, place, true }, keep, patch });
    }
  };
  add(this->SymmetryPlane, this->SymmetryPosition, Keep::Larger, "symmetry plane",
    { "symmetry", ransmesh::PatchType::Symmetry });
  add(this->WaterlinePlane, this->WaterlinePosition, Keep::Below, "waterline",
    { "waterline", ransmesh::PatchType::Symmetry });
  add(
    this->GroundPlane, this->GroundPosition, Keep::Above, "ground", { "ground", ransmesh::PatchType::Wall });
}

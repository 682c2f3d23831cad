#include "vtkMeshAdoption.h"

#include "ForeignMesh.h"

#include "MeshConversion.h"
#include "OptionRange.h"
#include "PatchNaming.h"
#include "RegionArrays.h"

#include "Boundary/MeshAdoption.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkMeshAdoption);

struct vtkMeshAdoption::Internals
{
  std::vector<std::pair<std::string, std::string>> TypeOfPattern;
};

namespace
{
// By number; empty names where there are none.
std::vector<std::string> regionNames(const ransmesh::NamedRegions& regions)
{
  constexpr int largest = 100000; // the list has a row for each number
  std::vector<std::string> names;
  for (const auto& [number, name] : regions.name)
  {
    if (number < largest)
    {
      names.resize(number + 1);
      names[number] = name;
    }
  }
  return names;
}
} // namespace

//------------------------------------------------------------------------------
vtkMeshAdoption::vtkMeshAdoption()
  : Lists(new Internals)
{
}

//------------------------------------------------------------------------------
vtkMeshAdoption::~vtkMeshAdoption() = default;

//------------------------------------------------------------------------------
void vtkMeshAdoption::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "Patch types set: " << this->Lists->TypeOfPattern.size() << "\n";
}

//------------------------------------------------------------------------------
void vtkMeshAdoption::SetPatchType(const char* pattern, const char* typeName)
{
  if (pattern && typeName)
  {
    this->Lists->TypeOfPattern.emplace_back(pattern, typeName);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkMeshAdoption::ClearPatchTypes()
{
  this->Lists->TypeOfPattern.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkMeshAdoption::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkMeshAdoption::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (const auto range = ransmesh::checkRanges({ { "FeatureAngle", this->FeatureAngle, 0, 180 } });
      !range.ok())
  {
    vtkErrorMacro(<< range.message << ".");
    return 0;
  }
  std::vector<vtkDataObject*> inputs;
  for (int i = 0; i < inputVector[0]->GetNumberOfInformationObjects(); ++i)
  {
    inputs.push_back(vtkDataObject::GetData(inputVector[0], i));
  }
  ransmesh::MeshData mesh;
  ransmesh::PatchTable patches;
  ransmesh::NamedRegions regions;
  std::vector<std::string> remarks;
  ransmesh::Outcome outcome = ransmesh::readForeignMesh(inputs, mesh, regions, patches, remarks);
  outcome = outcome.ok() ? ransmesh::adoptMesh(mesh, regions, patches, this->FeatureAngle, remarks) : outcome;
  outcome = outcome.ok() ? ransmesh::setTypes(this->Lists->TypeOfPattern, patches) : outcome;
  if (!outcome.ok())
  {
    vtkErrorMacro(<< "Cannot use the mesh: " << outcome.message << ".");
    return 0;
  }
  for (const std::string& remark : remarks)
  {
    vtkWarningMacro("Mesh adopted: " << remark << ".");
  }
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  ransmesh::writeMesh(mesh, patches, output);
  ransmesh::writeRegions(regions.of, output);
  ransmesh::writeRegionNames(regionNames(regions), output->GetFieldData());
  return 1;
}

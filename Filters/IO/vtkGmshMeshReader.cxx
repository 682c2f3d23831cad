#include "vtkGmshMeshReader.h"

#include "GmshContent.h"

#include "PatchFieldData.h"
#include "PatchNaming.h"
#include "PatchNumbering.h"
#include "RegionArrays.h"

#include "Support/DataContract.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

vtkStandardNewMacro(vtkGmshMeshReader);

namespace
{
using ransmesh::GmshContent;
using ransmesh::GmshElement;

std::string contentOf(const char* path)
{
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    throw std::runtime_error("it cannot be opened");
  }
  return { std::istreambuf_iterator<char>(file), {} };
}

// VTK's type of gmsh's shape; VTK_EMPTY_CELL for lines and points.
int cellTypeOf(int gmshType)
{
  constexpr int types[20] = { VTK_EMPTY_CELL, VTK_EMPTY_CELL, VTK_TRIANGLE, VTK_QUAD, VTK_TETRA,
    VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID, VTK_EMPTY_CELL, VTK_TRIANGLE, VTK_QUAD, VTK_TETRA, VTK_HEXAHEDRON,
    VTK_WEDGE, VTK_PYRAMID, VTK_EMPTY_CELL, VTK_QUAD, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID };
  return types[gmshType];
}

bool isSurface(const GmshElement& element)
{
  const int type = cellTypeOf(element.type);
  return type == VTK_TRIANGLE || type == VTK_QUAD;
}

// The patch of a surface element: numbers below 1 become others.
class Patches
{
public:
  explicit Patches(const GmshContent& content)
    : content_(content)
    , numbering_(table_)
    , hasGroups_(std::any_of(content.elements.begin(), content.elements.end(),
        [](const GmshElement& e) { return isSurface(e) && e.physical != 0; }))
  {
  }

  int patchOf(const GmshElement& element)
  {
    const int number = hasGroups_ ? element.physical : element.elementary;
    if (hasGroups_ && number == 0)
    {
      return 0; // in no group: no patch is known
    }
    const auto [known, isNew] = patchOf_.try_emplace(number);
    if (isNew)
    {
      const auto named = content_.names.find({ 2, number });
      const bool hasName = hasGroups_ && named != content_.names.end();
      const std::string name = hasName ? named->second : "patch_" + std::to_string(number);
      const auto told = content_.types.find(number);
      const auto type = ransmesh::patchTypeOf(told == content_.types.end() ? "" : told->second);
      known->second = numbering_.patchNamed(name, type.value_or(ransmesh::guessType(name)), number);
    }
    return known->second;
  }

  const ransmesh::PatchTable& table()
  {
    numbering_.nameGaps();
    return table_;
  }

private:
  const GmshContent& content_;
  ransmesh::PatchTable table_;
  ransmesh::PatchNumbering numbering_;
  std::map<int, int> patchOf_;
  bool hasGroups_;
};

bool isVolume(const GmshElement& element)
{
  return cellTypeOf(element.type) != VTK_EMPTY_CELL && !isSurface(element);
}

// Physical volumes are regions, if all elements are in one.
bool tellsRegions(const GmshContent& content)
{
  return std::none_of(content.elements.begin(), content.elements.end(),
    [](const GmshElement& e) { return isVolume(e) && e.physical < 1; });
}

std::vector<std::string> regionNames(const GmshContent& content)
{
  constexpr int largest = 100000; // the list has a row for each number
  std::vector<std::string> names;
  for (const auto& [what, name] : content.names)
  {
    const auto [dimension, number] = what;
    if (dimension == 3 && number > 0 && number < largest)
    {
      names.resize(std::max<std::size_t>(names.size(), number + 1));
      names[number] = name;
    }
  }
  return names;
}

void fill(const GmshContent& content, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(content.points.size()));
  for (std::size_t i = 0; i < content.points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), content.points[i].data());
  }
  grid->SetPoints(points);
  grid->AllocateExact(
    static_cast<vtkIdType>(content.elements.size()), static_cast<vtkIdType>(4 * content.elements.size()));
  vtkNew<vtkIntArray> patchIds;
  patchIds->SetName(ransmesh::contract::PatchId);
  vtkNew<vtkIntArray> regionIds;
  regionIds->SetName(ransmesh::contract::RegionId);
  Patches patches(content);
  for (const GmshElement& element : content.elements)
  {
    const int type = cellTypeOf(element.type);
    if (type != VTK_EMPTY_CELL)
    {
      const std::vector<vtkIdType> corners(
        element.points.begin(), element.points.begin() + ransmesh::gmshCorners(element.type));
      grid->InsertNextCell(type, static_cast<vtkIdType>(corners.size()), corners.data());
      patchIds->InsertNextValue(isSurface(element) ? patches.patchOf(element) : 0);
      regionIds->InsertNextValue(isVolume(element) ? element.physical : 0);
    }
  }
  grid->GetCellData()->AddArray(patchIds);
  if (tellsRegions(content))
  {
    grid->GetCellData()->AddArray(regionIds);
    ransmesh::writeRegionNames(regionNames(content), grid->GetFieldData());
  }
  ransmesh::writePatches(patches.table(), grid->GetFieldData());
}
} // namespace

//------------------------------------------------------------------------------
vtkGmshMeshReader::vtkGmshMeshReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkGmshMeshReader::~vtkGmshMeshReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
void vtkGmshMeshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "") << "\n";
}

//------------------------------------------------------------------------------
int vtkGmshMeshReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("No file is given: set FileName.");
    return 0;
  }
  try
  {
    fill(ransmesh::readGmsh(contentOf(this->FileName)), vtkUnstructuredGrid::GetData(outputVector));
    return 1;
  }
  catch (const std::runtime_error& error)
  {
    vtkErrorMacro(<< this->FileName << " is no mesh of gmsh that can be read: " << error.what() << ".");
    return 0;
  }
}

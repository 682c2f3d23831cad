#include "vtkNamedBlocksToMesh.h"

#include "NamedBlocks.h"
#include "PatchFieldData.h"
#include "RegionArrays.h"

#include "Support/DataContract.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributesFieldList.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <sstream>
#include <unordered_map>

vtkStandardNewMacro(vtkNamedBlocksToMesh);

namespace
{
using namespace ransmesh;
using Coordinates = std::array<double, 3>;

struct HashOfCoordinates
{
  std::size_t operator()(const Coordinates& x) const
  {
    std::size_t hash = 0;
    for (const double value : x)
    {
      hash = (hash ^ std::hash<double>()(value)) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 29;
    }
    return hash;
  }
};

Coordinates pointOf(vtkDataSet* data, vtkIdType i)
{
  Coordinates x;
  data->GetPoint(i, x.data());
  return x;
}

// Puts the mesh together, block by block.
class MeshBuilder
{
public:
  MeshBuilder(const NamedBlocks& blocks, vtkUnstructuredGrid* mesh)
    : blocks_(blocks)
    , mesh_(mesh)
  {
    vtkIdType cells = 0;
    for (const auto* list : { &blocks_.volumes, &blocks_.surfaces })
    {
      for (const NamedBlock& block : *list)
      {
        cellArrays_.IntersectFieldList(block.data->GetCellData());
        cells += block.data->GetNumberOfCells();
      }
    }
    for (const NamedBlock& block : blocks_.volumes)
    {
      pointArrays_.IntersectFieldList(block.data->GetPointData());
    }
    points_->SetDataTypeToDouble();
    mesh_->SetPoints(points_);
    mesh_->Allocate(cells);
    pointArrays_.CopyAllocate(mesh_->GetPointData(), vtkDataSetAttributes::COPYTUPLE, 0, 1000);
    cellArrays_.CopyAllocate(mesh_->GetCellData(), vtkDataSetAttributes::COPYTUPLE, cells, 1000);
  }

  void addVolumes()
  {
    for (std::size_t v = 0; v < blocks_.volumes.size(); ++v)
    {
      vtkDataSet* volume = blocks_.volumes[v].data;
      std::vector<vtkIdType> numbers(volume->GetNumberOfPoints());
      for (vtkIdType i = 0; i < volume->GetNumberOfPoints(); ++i)
      {
        numbers[i] = enter(volume, i, static_cast<int>(v));
      }
      addCells(volume, numbers, 0);
      regions_.resize(mesh_->GetNumberOfCells(), static_cast<int>(v) + 1);
    }
  }

  // BadInput where a point is none of the volume's.
  Outcome addSurface(const NamedBlock& block, int patch)
  {
    std::vector<vtkIdType> numbers(block.data->GetNumberOfPoints());
    vtkDataArray* ids = block.data->GetPointData()->GetArray(contract::MeshPointId);
    for (vtkIdType i = 0; i < block.data->GetNumberOfPoints(); ++i)
    {
      numbers[i] = find(block.data, i, blocks_.volumes.size() == 1 ? ids : nullptr);
      if (numbers[i] < 0)
      {
        const Coordinates x = pointOf(block.data, i);
        std::ostringstream text;
        text.precision(17);
        text << "block '" << block.patch.name << "' has a point at (" << x[0] << ", " << x[1] << ", " << x[2]
             << ") that is no point of the volume: faces and volume must have exactly the same points";
        return Outcome::badInput(text.str());
      }
    }
    addCells(block.data, numbers, patch);
    return Outcome::done();
  }

  void finish(const PatchTable& patches)
  {
    patchIds_->SetName(contract::PatchId);
    mesh_->GetCellData()->AddArray(patchIds_);
    if (blocks_.volumes.size() > 1 && !mesh_->GetCellData()->HasArray(contract::RegionId))
    {
      numberRegions();
    }
    writePatches(patches, mesh_->GetFieldData());
  }

private:
  // Each block of volume cells is a region; blocks of one name are one.
  void numberRegions()
  {
    std::vector<std::string> names(1);
    std::vector<int> number;
    for (const NamedBlock& volume : blocks_.volumes)
    {
      const std::string& name = volume.patch.name;
      const auto known = std::find(names.begin() + 1, names.end(), name);
      number.push_back(static_cast<int>(known - names.begin()));
      if (known == names.end())
      {
        names.push_back(name);
      }
    }
    std::transform(
      regions_.begin(), regions_.end(), regions_.begin(), [&number](int v) { return number[v - 1]; });
    writeRegions(regions_, mesh_);
    writeRegionNames(names, mesh_->GetFieldData());
  }

  // One volume keeps its points as they are; points of several that coincide are one.
  vtkIdType enter(vtkDataSet* volume, vtkIdType i, int block)
  {
    const Coordinates x = pointOf(volume, i);
    if (blocks_.volumes.size() > 1)
    {
      const auto [place, fresh] = numbers_.try_emplace(x, points_->GetNumberOfPoints());
      if (!fresh)
      {
        return place->second;
      }
    }
    const vtkIdType number = points_->InsertNextPoint(x.data());
    pointArrays_.CopyData(block, volume->GetPointData(), i, mesh_->GetPointData(), number);
    return number;
  }

  vtkIdType find(vtkDataSet* surface, vtkIdType i, vtkDataArray* ids)
  {
    const Coordinates x = pointOf(surface, i);
    const auto said = ids ? static_cast<vtkIdType>(ids->GetTuple1(i)) : -1;
    if (said >= 0 && said < points_->GetNumberOfPoints())
    {
      Coordinates there;
      points_->GetPoint(said, there.data());
      if (there == x)
      {
        return said;
      }
    }
    if (numbers_.empty())
    {
      enterAll();
    }
    const auto found = numbers_.find(x);
    return found == numbers_.end() ? -1 : found->second;
  }

  void enterAll()
  {
    for (vtkIdType i = 0; i < points_->GetNumberOfPoints(); ++i)
    {
      Coordinates x;
      points_->GetPoint(i, x.data());
      numbers_.try_emplace(x, i);
    }
  }

  void addCells(vtkDataSet* data, const std::vector<vtkIdType>& numbers, int patch)
  {
    vtkNew<vtkIdList> corners;
    for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
    {
      data->GetCellPoints(c, corners);
      std::for_each(corners->begin(), corners->end(), [&numbers](vtkIdType& p) { p = numbers[p]; });
      const vtkIdType cell = mesh_->InsertNextCell(data->GetCellType(c), corners);
      cellArrays_.CopyData(block_, data->GetCellData(), c, mesh_->GetCellData(), cell);
      patchIds_->InsertNextValue(patch);
    }
    ++block_;
  }

  const NamedBlocks& blocks_;
  vtkUnstructuredGrid* mesh_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkIntArray> patchIds_;
  vtkDataSetAttributesFieldList cellArrays_;
  vtkDataSetAttributesFieldList pointArrays_;
  std::vector<int> regions_; // of the volume cells: their block, from 1
  int block_ = 0;            // the one that is being added, of all
  std::unordered_map<Coordinates, vtkIdType, HashOfCoordinates> numbers_;
};

// Blocks of one name are one patch. Names that the input's own table has keep their numbers there.
std::vector<int> numberPatches(const std::vector<NamedBlock>& surfaces, PatchTable& table)
{
  if (table.empty())
  {
    table.push_back({ "fluid", PatchType::Patch });
  }
  std::vector<int> numbers;
  for (const NamedBlock& block : surfaces)
  {
    Patch patch = block.patch;
    if (patch.name.empty())
    {
      patch.name = "patch_" + std::to_string(table.size());
    }
    auto at = std::find_if(
      table.begin() + 1, table.end(), [&patch](const Patch& other) { return other.name == patch.name; });
    if (at == table.end())
    {
      at = table.insert(table.end(), patch);
    }
    numbers.push_back(static_cast<int>(at - table.begin()));
  }
  return numbers;
}

// By the numbers of their patches.
void sortByPatch(std::vector<NamedBlock>& surfaces, std::vector<int>& numbers)
{
  std::multimap<int, NamedBlock> sorted;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    sorted.emplace(numbers[i], surfaces[i]);
  }
  surfaces.clear();
  numbers.clear();
  for (const auto& [number, block] : sorted)
  {
    numbers.push_back(number);
    surfaces.push_back(block);
  }
}

Outcome build(NamedBlocks& blocks, PatchTable table, vtkUnstructuredGrid* output)
{
  if (table.empty() && !blocks.volumes[0].patch.name.empty())
  {
    table.push_back({ blocks.volumes[0].patch.name, PatchType::Patch });
  }
  std::vector<int> numbers = numberPatches(blocks.surfaces, table);
  sortByPatch(blocks.surfaces, numbers);
  MeshBuilder builder(blocks, output);
  builder.addVolumes();
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    if (Outcome outcome = builder.addSurface(blocks.surfaces[i], numbers[i]); !outcome.ok())
    {
      return outcome;
    }
  }
  builder.finish(table);
  return Outcome::done();
}
} // namespace

int vtkNamedBlocksToMesh::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkNamedBlocksToMesh::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* input = vtkCompositeDataSet::GetData(inputVector[0]);
  auto* output = vtkUnstructuredGrid::GetData(outputVector);
  NamedBlocks blocks;
  Outcome outcome = findBlocks(input, blocks);
  if (outcome.ok())
  {
    output->GetFieldData()->ShallowCopy(input->GetFieldData());
    outcome = build(blocks, readPatches(input->GetFieldData()), output);
  }
  if (!outcome.ok())
  {
    output->Initialize();
    vtkErrorMacro("" << outcome.message);
    return 0;
  }
  return 1;
}

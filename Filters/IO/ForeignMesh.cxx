#include "ForeignMesh.h"

#include "PatchFieldData.h"
#include "PatchNaming.h"
#include "PatchNumbering.h"
#include "RegionArrays.h"

#include "Support/DataContract.h"

#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

namespace ransmesh
{
namespace
{
struct Part
{
  vtkDataSet* data;
  std::string name; // of the block, or empty
};

std::vector<Part> partsOf(const std::vector<vtkDataObject*>& inputs)
{
  std::vector<Part> parts;
  for (vtkDataObject* input : inputs)
  {
    if (auto* one = vtkDataSet::SafeDownCast(input))
    {
      parts.push_back({ one, "" });
    }
    auto* tree = vtkDataObjectTree::SafeDownCast(input);
    if (!tree)
    {
      continue;
    }
    const auto leaf = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
    leaf->VisitOnlyLeavesOn();
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      if (auto* data = vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject()))
      {
        vtkInformation* about = leaf->HasCurrentMetaData() ? leaf->GetCurrentMetaData() : nullptr;
        const char* name = about ? about->Get(vtkCompositeDataSet::NAME()) : nullptr;
        parts.push_back({ data, name ? name : "" });
      }
    }
  }
  return parts;
}

// Corners of the cells that a mesh is made of; 0 for lines and points; nothing for all others.
std::optional<int> cornersOf(int type)
{
  switch (type)
  {
    case VTK_TETRA:
    case VTK_QUADRATIC_TETRA:
      return 4;
    case VTK_TRIANGLE:
    case VTK_QUADRATIC_TRIANGLE:
      return 3;
    case VTK_EMPTY_CELL:
    case VTK_VERTEX:
    case VTK_POLY_VERTEX:
    case VTK_LINE:
    case VTK_POLY_LINE:
    case VTK_QUADRATIC_EDGE:
      return 0;
    default:
      return std::nullopt;
  }
}

class Reader
{
public:
  Reader(MeshData& mesh, NamedRegions& regions, PatchTable& patches, std::vector<std::string>& remarks)
    : mesh_(mesh)
    , regions_(regions)
    , numbering_(patches)
    , remarks_(remarks)
  {
  }

  Outcome read(const Part& part)
  {
    if (mesh_.points.size() + part.data->GetNumberOfPoints() > std::numeric_limits<Index>::max() / 8)
    {
      return Outcome::badInput("the mesh has too many points for 32-bit numbers");
    }
    const auto offset = static_cast<Index>(mesh_.points.size());
    for (vtkIdType v = 0; v < part.data->GetNumberOfPoints(); ++v)
    {
      double x[3];
      part.data->GetPoint(v, x);
      mesh_.points.push_back({ x[0], x[1], x[2] });
    }
    const std::vector<int> patch = patchesOf(part);
    const auto region = numbersIn(part.data, contract::RegionId);
    vtkNew<vtkIdList> v;
    for (vtkIdType c = 0; c < part.data->GetNumberOfCells(); ++c)
    {
      const auto corners = cornersOf(part.data->GetCellType(c));
      if (!corners)
      {
        return refuse(part.data, c);
      }
      part.data->GetCellPoints(c, v);
      isCurved_ = isCurved_ || (*corners > 0 && v->GetNumberOfIds() > *corners);
      const auto at = [&](int i) { return static_cast<Index>(v->GetId(i)) + offset; };
      if (*corners == 4)
      {
        mesh_.tetrahedra.push_back({ at(0), at(1), at(2), at(3) });
        enterRegion(region ? (*region)[c] : 0, part.data->GetFieldData());
      }
      else if (*corners == 3)
      {
        mesh_.triangles.push_back({ at(0), at(1), at(2) });
        mesh_.trianglePatch.push_back(patch[c]);
      }
    }
    return Outcome::done();
  }

  void finish()
  {
    numbering_.nameGaps();
    if (regions_.name.contains(0)) // tetrahedra without one
    {
      regions_ = {};
    }
    if (isCurved_)
    {
      remarks_.emplace_back("cells of second order are taken by their corners");
    }
  }

private:
  void enterRegion(int number, vtkFieldData* fieldData)
  {
    regions_.of.push_back(std::max(number, 0));
    const auto [name, isNew] = regions_.name.try_emplace(regions_.of.back());
    if (isNew)
    {
      name->second = regionName(fieldData, number, "region");
    }
  }

  static Outcome refuse(vtkDataSet* data, vtkIdType cell)
  {
    const int type = data->GetCellType(cell);
    return Outcome::badInput("cell " + std::to_string(cell) + " is a " +
      vtkCellTypes::GetClassNameFromTypeId(type) +
      "; the mesh must consist of tetrahedra and triangles: make it so in the program that it comes from, or "
      "pass it through vtkDataSetTriangleFilter");
  }

  // Of each cell of a part; 0: unknown.
  std::vector<int> patchesOf(const Part& part)
  {
    const auto cells = static_cast<std::size_t>(part.data->GetNumberOfCells());
    if (auto numbers = numbersIn(part.data, contract::PatchId))
    {
      return renumber(*numbers, readPatches(part.data->GetFieldData()), part.name);
    }
    if (auto numbers = foreignNumbersIn(part.data))
    {
      return renumber(*numbers, {}, part.name);
    }
    const bool isSurface = holdsNoTetrahedra(part.data) && !part.name.empty();
    return std::vector<int>(cells, isSurface ? numbering_.patchNamed(part.name, guessType(part.name), 0) : 0);
  }

  static bool holdsNoTetrahedra(vtkDataSet* data)
  {
    for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
    {
      if (cornersOf(data->GetCellType(c)).value_or(4) == 4)
      {
        return false;
      }
    }
    return true;
  }

  std::vector<int> renumber(std::vector<int> numbers, const PatchTable& named, const std::string& block)
  {
    std::map<int, int> patchOf = { { 0, 0 } };
    for (int& number : numbers)
    {
      const auto [known, isNew] = patchOf.try_emplace(number);
      if (isNew)
      {
        const bool hasName = number > 0 && number < static_cast<int>(named.size());
        const std::string made = (block.empty() ? "patch" : block) + "_" + std::to_string(number);
        const std::string name = hasName ? named[number].name : made;
        const bool hasType = hasName && named[number].type != PatchType::Patch;
        known->second = numbering_.patchNamed(name, hasType ? named[number].type : guessType(name), number);
      }
      number = known->second;
    }
    return numbers;
  }

  MeshData& mesh_;
  NamedRegions& regions_;
  PatchNumbering numbering_;
  std::vector<std::string>& remarks_;
  bool isCurved_ = false;
};
} // namespace

Outcome readForeignMesh(const std::vector<vtkDataObject*>& inputs, MeshData& mesh, NamedRegions& regions,
  PatchTable& patches, std::vector<std::string>& remarks)
{
  Reader reader(mesh, regions, patches, remarks);
  for (const Part& part : partsOf(inputs))
  {
    if (Outcome outcome = reader.read(part); !outcome.ok())
    {
      return outcome;
    }
  }
  reader.finish();
  return mesh.tetrahedra.empty()
    ? Outcome::badInput("the input has no tetrahedra: connect a mesh of a volume")
    : Outcome::done();
}
} // namespace ransmesh

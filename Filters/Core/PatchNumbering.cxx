#include "PatchNumbering.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ransmesh
{
namespace
{
// Where other tools leave patch numbers: gmsh (through its VTK writer and meshio), SimVascular, Medit,
// SU2, FEniCS, netgen (both through meshio), VTK's readers of STL and OBJ.
constexpr const char* ForeignArrays[] = { "CellEntityIds", "gmsh:physical", "ModelFaceID", "medit:ref",
  "su2:tag", "cell_tags", "netgen:index", "STLSolidLabeling", "GroupIds" };
} // namespace

std::optional<std::vector<int>> numbersIn(vtkDataSet* data, const char* name)
{
  vtkDataArray* array = data->GetCellData()->GetArray(name);
  if (!array || array->GetNumberOfComponents() != 1)
  {
    return std::nullopt;
  }
  std::vector<int> numbers;
  numbers.reserve(array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const double value = array->GetTuple1(i);
    if (!(std::fabs(value) < std::numeric_limits<int>::max()) || value != std::floor(value))
    {
      return std::nullopt;
    }
    numbers.push_back(static_cast<int>(value));
  }
  return numbers;
}

std::optional<std::vector<int>> foreignNumbersIn(vtkDataSet* data)
{
  for (const char* array : ForeignArrays)
  {
    auto numbers = numbersIn(data, array);
    if (numbers && !numbers->empty() &&
      *std::min_element(numbers->begin(), numbers->end()) !=
        *std::max_element(numbers->begin(), numbers->end()))
    {
      return numbers;
    }
  }
  return std::nullopt;
}

Outcome readPatchId(vtkDataArray* patchIds, vtkIdType cell, int& patch)
{
  const double value = patchIds->GetTuple1(cell);
  if (!(value >= 1 && value <= PatchNumbering::LargestKept) || value != std::floor(value))
  {
    return Outcome::badInput("cell " + std::to_string(cell) + " of the boundary has PatchId " +
      std::to_string(value) + "; it needs a whole number from 1 to " +
      std::to_string(PatchNumbering::LargestKept));
  }
  patch = static_cast<int>(value);
  return Outcome::done();
}

PatchNumbering::PatchNumbering(PatchTable& patches)
  : patches_(patches)
{
  patches_.assign(1, { "fluid", PatchType::Patch });
}

int PatchNumbering::patchNamed(const std::string& name, PatchType type, int wanted)
{
  if (const auto known = numberOf_.find(name); known != numberOf_.end())
  {
    return known->second;
  }
  const bool free = wanted > 0 && wanted <= LargestKept &&
    (wanted >= static_cast<int>(patches_.size()) || patches_[wanted].name.empty());
  const int number = free ? wanted : static_cast<int>(patches_.size());
  if (number >= static_cast<int>(patches_.size()))
  {
    patches_.resize(number + 1);
  }
  patches_[number] = { name, type };
  numberOf_[name] = number;
  return number;
}

void PatchNumbering::nameGaps()
{
  for (std::size_t i = 1; i < patches_.size(); ++i)
  {
    if (patches_[i].name.empty())
    {
      patches_[i].name = "unused_" + std::to_string(i);
    }
  }
}
} // namespace ransmesh

#include "RegionArrays.h"

#include "Support/DataContract.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>
#include <set>

namespace ransmesh
{
std::vector<int> readRegions(vtkUnstructuredGrid* grid)
{
  std::vector<Index> tets;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    if (grid->GetCellType(c) == VTK_TETRA)
    {
      tets.push_back(static_cast<Index>(c));
    }
  }
  return readRegions(grid, tets);
}

std::vector<int> readRegions(vtkUnstructuredGrid* grid, const std::vector<Index>& cells)
{
  vtkDataArray* array = grid->GetCellData()->GetArray(contract::RegionId);
  std::vector<int> regions;
  if (!array || array->GetNumberOfComponents() != 1)
  {
    return regions;
  }
  for (const Index c : cells)
  {
    const double number = array->GetTuple1(c);
    if (!(number >= 1 && number <= std::numeric_limits<int>::max()) || number != static_cast<int>(number))
    {
      return {};
    }
    regions.push_back(static_cast<int>(number));
  }
  return regions;
}

void writeRegions(const std::vector<int>& ofTets, vtkUnstructuredGrid* grid)
{
  if (ofTets.empty())
  {
    return;
  }
  vtkNew<vtkIntArray> array;
  array->SetName(contract::RegionId);
  array->SetNumberOfValues(grid->GetNumberOfCells());
  array->FillValue(0);
  std::copy(ofTets.begin(), ofTets.end(), array->GetPointer(0));
  grid->GetCellData()->AddArray(array);
}

std::string regionName(vtkFieldData* fieldData, int number, const std::string& fluid)
{
  auto* names = vtkStringArray::SafeDownCast(fieldData->GetAbstractArray(contract::RegionNames));
  const bool isNamed =
    names && number > 0 && number < names->GetNumberOfValues() && !names->GetValue(number).empty();
  return isNamed ? std::string(names->GetValue(number)) : fluid + "_" + std::to_string(number);
}

void writeRegionNames(const std::vector<std::string>& names, vtkFieldData* fieldData)
{
  vtkNew<vtkStringArray> array;
  array->SetName(contract::RegionNames);
  for (const std::string& name : names)
  {
    array->InsertNextValue(name);
  }
  fieldData->AddArray(array);
}

std::string lostRegions(const std::vector<int>& before, const std::vector<int>& now)
{
  const std::set<int> kept(now.begin(), now.end());
  std::string lost;
  for (const int number : std::set<int>(before.begin(), before.end()))
  {
    lost += kept.contains(number) ? "" : (lost.empty() ? "" : ", ") + std::to_string(number);
  }
  return lost.empty() ? lost
                      : "no triangles divide these regions from others, whose number they have now: " + lost;
}
} // namespace ransmesh

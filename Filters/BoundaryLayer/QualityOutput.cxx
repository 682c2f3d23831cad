#include "QualityOutput.h"

#include "TableColumns.h"

#include "Quality/ReportRows.h"
#include "Support/DataContract.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
// A cell that was cut into several shows what they come to together, or the worst of them.
enum class Together
{
  Sum,
  Largest,
  Smallest
};

double together(double a, double b, Together how)
{
  return how == Together::Sum ? a + b : how == Together::Largest ? std::max(a, b) : std::min(a, b);
}

// Values of tetrahedra go to their cells; the boundary gets those of the tetrahedra behind it, or nothing.
void addCellArray(const char* name, const std::vector<double>& values, Together how,
  const std::vector<HalfFace>* innerFace, const QualityInput& input, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfValues(grid->GetNumberOfCells());
  array->FillValue(0);
  std::vector<char> isSet(static_cast<std::size_t>(grid->GetNumberOfCells()), 0);
  const auto put = [&](Index cell, double value)
  {
    array->SetValue(cell, isSet[cell] ? together(array->GetValue(cell), value, how) : value);
    isSet[cell] = 1;
  };
  for (std::size_t t = 0; t < values.size(); ++t)
  {
    put(input.tetCell[t], values[t]);
  }
  for (std::size_t i = 0; innerFace && i < innerFace->size(); ++i)
  {
    const HalfFace inner = (*innerFace)[i];
    put(input.triangleCell[i], inner != None ? values[tetOf(inner)] : 0);
  }
  grid->GetCellData()->AddArray(array);
}
} // namespace

void addCellArrays(const CellMeasures& cells, const QualityInput& input, vtkUnstructuredGrid* grid)
{
  const auto* behind = &cells.innerFace;
  addCellArray(contract::Volume, cells.volume, Together::Sum, nullptr, input, grid);
  addCellArray(contract::LargestDihedral, cells.largestDihedral, Together::Largest, behind, input, grid);
  addCellArray(contract::SmallestDihedral, cells.smallestDihedral, Together::Smallest, behind, input, grid);
  addCellArray(contract::Stretching, cells.stretching, Together::Largest, behind, input, grid);
  addCellArray(contract::Quality, cells.quality, Together::Smallest, behind, input, grid);
}

void writeSummary(const QualityReport& report, vtkTable* table)
{
  table->Initialize();
  auto* quantity = addColumn<vtkStringArray>("Quantity", table);
  auto* value = addColumn<vtkDoubleArray>("Value", table);
  auto* unit = addColumn<vtkStringArray>("Unit", table);
  auto* scope = addColumn<vtkStringArray>("Scope", table);
  for (const ReportRow& row : reportRows(report))
  {
    quantity->InsertNextValue(row.quantity);
    value->InsertNextValue(row.value);
    unit->InsertNextValue(row.unit);
    scope->InsertNextValue(row.scope);
  }
}

void writeHistograms(const QualityReport& report, vtkTable* table)
{
  table->Initialize();
  auto* number = addColumn<vtkIntArray>("Histogram", table);
  auto* quantity = addColumn<vtkStringArray>("Quantity", table);
  auto* scope = addColumn<vtkStringArray>("Scope", table);
  auto* low = addColumn<vtkDoubleArray>("BinLow", table);
  auto* high = addColumn<vtkDoubleArray>("BinHigh", table);
  auto* count = addColumn<vtkIdTypeArray>("Count", table);
  for (std::size_t i = 0; i < report.histograms.size(); ++i)
  {
    const Histogram& histogram = report.histograms[i];
    for (std::size_t bin = 0; bin < histogram.count.size(); ++bin)
    {
      number->InsertNextValue(static_cast<int>(i));
      quantity->InsertNextValue(histogram.quantity);
      scope->InsertNextValue(histogram.scope);
      low->InsertNextValue(histogram.low[bin]);
      high->InsertNextValue(histogram.high[bin]);
      count->InsertNextValue(static_cast<vtkIdType>(histogram.count[bin]));
    }
  }
}

std::vector<StopCount> countStops(vtkPolyData* boundary)
{
  std::vector<StopCount> stops;
  vtkDataArray* reason = boundary ? boundary->GetPointData()->GetArray(contract::StopReason) : nullptr;
  auto* names = boundary
    ? vtkStringArray::SafeDownCast(boundary->GetFieldData()->GetAbstractArray(contract::StopReasonNames))
    : nullptr;
  if (!reason || !names)
  {
    return stops;
  }
  std::vector<std::size_t> count(static_cast<std::size_t>(names->GetNumberOfValues()), 0);
  for (vtkIdType i = 0; i < reason->GetNumberOfTuples(); ++i)
  {
    const double code = reason->GetTuple1(i);
    if (code >= 1 && code < static_cast<double>(count.size())) // 0: nothing stopped it
    {
      ++count[static_cast<std::size_t>(code)];
    }
  }
  for (std::size_t i = 1; i < count.size(); ++i)
  {
    if (count[i] > 0)
    {
      stops.push_back({ names->GetValue(static_cast<vtkIdType>(i)), count[i] });
    }
  }
  return stops;
}
} // namespace ransmesh

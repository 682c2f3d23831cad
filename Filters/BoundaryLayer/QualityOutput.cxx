#include "QualityOutput.h"

#include "Quality/ReportRows.h"
#include "Support/DataContract.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
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

namespace ransmesh
{
namespace
{
// Values of tetrahedra go to tetrahedra in order; triangles get that of the tetrahedron behind them.
void addCellArray(const char* name, const std::vector<double>& values, const std::vector<HalfFace>* innerFace,
  vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfValues(grid->GetNumberOfCells());
  std::size_t tet = 0;
  std::size_t triangle = 0;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    if (grid->GetCellType(c) == VTK_TETRA)
    {
      array->SetValue(c, values[tet++]);
      continue;
    }
    const HalfFace inner = innerFace ? (*innerFace)[triangle++] : None;
    array->SetValue(c, inner != None ? values[tetOf(inner)] : 0);
  }
  grid->GetCellData()->AddArray(array);
}

template <class Array>
Array* addColumn(const char* name, vtkTable* table)
{
  vtkNew<Array> column;
  column->SetName(name);
  table->AddColumn(column);
  return column;
}
} // namespace

void addCellArrays(const CellMeasures& cells, vtkUnstructuredGrid* grid)
{
  addCellArray(contract::Volume, cells.volume, nullptr, grid);
  addCellArray(contract::LargestDihedral, cells.largestDihedral, &cells.innerFace, grid);
  addCellArray(contract::SmallestDihedral, cells.smallestDihedral, &cells.innerFace, grid);
  addCellArray(contract::Stretching, cells.stretching, &cells.innerFace, grid);
  addCellArray(contract::Quality, cells.quality, &cells.innerFace, grid);
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

std::vector<int> readLayerIds(vtkUnstructuredGrid* grid)
{
  std::vector<int> layerIds;
  vtkDataArray* array = grid->GetCellData()->GetArray(contract::LayerId);
  if (!array || array->GetNumberOfComponents() != 1)
  {
    return layerIds;
  }
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    if (grid->GetCellType(c) == VTK_TETRA)
    {
      layerIds.push_back(static_cast<int>(array->GetTuple1(c)));
    }
  }
  return layerIds;
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

#include "EnrichmentOutput.h"

#include "LargeArray.h"
#include "MeshConversion.h"
#include "PatchFieldData.h"

#include "Support/DataContract.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
// An array with a value for each cell: the tetrahedra's own, fill for the triangles behind them.
template <class Array, class Value>
void addCellArray(const char* name, const std::vector<Value>& ofTets, Value fill, vtkUnstructuredGrid* grid)
{
  vtkNew<Array> array;
  array->SetName(name);
  auto* const end =
    std::copy(ofTets.begin(), ofTets.end(), resizeLarge(array.Get(), grid->GetNumberOfCells()));
  std::fill(end, array->GetPointer(0) + grid->GetNumberOfCells(), fill);
  grid->GetCellData()->AddArray(array);
}

// Only the points that triangles use, in order of number.
std::vector<vtkIdType> numberBoundaryPoints(const MeshData& mesh, vtkPoints* points)
{
  std::vector<vtkIdType> number(mesh.points.size(), -1);
  for (const auto& triangle : mesh.triangles)
  {
    for (const Index v : triangle)
    {
      number[v] = 0;
    }
  }
  vtkIdType next = 0;
  points->SetDataTypeToDouble();
  for (std::size_t v = 0; v < number.size(); ++v)
  {
    if (number[v] == 0)
    {
      number[v] = next++;
      points->InsertNextPoint(mesh.points[v].x, mesh.points[v].y, mesh.points[v].z);
    }
  }
  return number;
}

template <class Array>
Array* addPointArray(const char* name, vtkPolyData* boundary)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(boundary->GetNumberOfPoints());
  array->FillValue(0);
  boundary->GetPointData()->AddArray(array);
  return Array::SafeDownCast(boundary->GetPointData()->GetArray(name));
}

void addWallArrays(
  const std::vector<WallPoint>& wallPoints, const std::vector<vtkIdType>& number, vtkPolyData* boundary)
{
  auto* asked = addPointArray<vtkIntArray>(contract::LayersAsked, boundary);
  auto* achieved = addPointArray<vtkIntArray>(contract::LayersAchieved, boundary);
  auto* firstAsked = addPointArray<vtkDoubleArray>(contract::FirstHeightAsked, boundary);
  auto* firstAchieved = addPointArray<vtkDoubleArray>(contract::FirstHeightAchieved, boundary);
  auto* reason = addPointArray<vtkIntArray>(contract::StopReason, boundary);
  for (const WallPoint& point : wallPoints)
  {
    const vtkIdType i = number[point.point];
    asked->SetValue(i, point.layersAsked);
    achieved->SetValue(i, point.layersAchieved);
    firstAsked->SetValue(i, point.firstHeightAsked);
    firstAchieved->SetValue(i, point.firstHeightAchieved);
    reason->SetValue(i, static_cast<int>(point.reason));
  }
}

void addReasonNames(vtkFieldData* fieldData)
{
  vtkNew<vtkStringArray> names;
  names->SetName(contract::StopReasonNames);
  for (const std::string_view text : StopReasonTexts)
  {
    names->InsertNextValue(std::string(text));
  }
  fieldData->AddArray(names);
}

void carryPointData(const std::vector<Index>& origin, vtkPointData* from, vtkPointData* to)
{
  if (from->GetNumberOfArrays() == 0)
  {
    return;
  }
  to->CopyAllocate(from, static_cast<vtkIdType>(origin.size()));
  for (std::size_t i = 0; i < origin.size(); ++i)
  {
    to->CopyData(from, origin[i], static_cast<vtkIdType>(i));
  }
}
} // namespace

void writeEnrichedMesh(
  const EnrichedMesh& enriched, const PatchTable& patches, vtkPointData* inputData, vtkUnstructuredGrid* grid)
{
  writeMesh(enriched.mesh, patches, grid);
  carryPointData(enriched.origin, inputData, grid->GetPointData());
  addCellArray<vtkIntArray>(contract::LayerId, enriched.layer, 0, grid);
  addCellArray<vtkIntArray>(contract::PrismId, numberPrisms(enriched), None, grid);
  vtkNew<vtkIntArray> columns;
  columns->SetName(contract::ColumnId);
  std::copy(
    enriched.column.begin(), enriched.column.end(), resizeLarge(columns.Get(), grid->GetNumberOfPoints()));
  grid->GetPointData()->AddArray(columns);
}

void writeEnrichedBoundary(const EnrichedMesh& enriched, const PatchTable& patches, vtkPolyData* boundary)
{
  boundary->Initialize();
  vtkNew<vtkPoints> points;
  const std::vector<vtkIdType> number = numberBoundaryPoints(enriched.mesh, points);
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIntArray> patchIds;
  patchIds->SetName(contract::PatchId);
  for (std::size_t i = 0; i < enriched.mesh.triangles.size(); ++i)
  {
    const auto& v = enriched.mesh.triangles[i];
    triangles->InsertNextCell({ number[v[0]], number[v[1]], number[v[2]] });
    patchIds->InsertNextValue(enriched.mesh.trianglePatch[i]);
  }
  boundary->SetPoints(points);
  boundary->SetPolys(triangles);
  boundary->GetCellData()->AddArray(patchIds);
  addWallArrays(enriched.wallPoints, number, boundary);
  addReasonNames(boundary->GetFieldData());
  writePatches(patches, boundary->GetFieldData());
}
} // namespace ransmesh

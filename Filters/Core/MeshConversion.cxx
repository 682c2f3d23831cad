#include "MeshConversion.h"

#include "ArrayLengths.h"
#include "LargeArray.h"
#include "PatchFieldData.h"
#include "PatchNumbering.h"

#include "Mesh/FaceMatching.h"
#include "Mesh/Tidying.h"
#include "Support/DataContract.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>

namespace ransmesh
{
namespace
{
Outcome checkGrid(vtkUnstructuredGrid* grid)
{
  if (!grid || grid->GetNumberOfPoints() == 0 || grid->GetNumberOfCells() == 0)
  {
    return Outcome::badInput("the input is empty: connect a tetrahedral mesh");
  }
  if (grid->GetNumberOfPoints() > std::numeric_limits<Index>::max() / 8)
  {
    return Outcome::badInput("the mesh has too many points for 32-bit numbers");
  }
  vtkIdType tets = 0;
  vtkIdType triangles = 0;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    const int type = grid->GetCellType(c);
    tets += type == VTK_TETRA;
    triangles += type == VTK_TRIANGLE;
    if (type != VTK_TETRA && type != VTK_TRIANGLE)
    {
      return Outcome::badInput("cell " + std::to_string(c) + " is of VTK type " + std::to_string(type) +
        "; the mesh must hold tetrahedra and boundary triangles only: pass it through "
        "vtkDataSetTriangleFilter, "
        "or make it with vtkIsotropicTetMesher");
    }
  }
  if (tets == 0)
  {
    return Outcome::badInput("the mesh has no tetrahedra: make it with vtkIsotropicTetMesher");
  }
  auto* patchIds = grid->GetCellData()->GetArray(contract::PatchId);
  if (triangles == 0 || !patchIds || patchIds->GetNumberOfComponents() != 1)
  {
    return Outcome::badInput("the mesh has no boundary triangles with a cell array PatchId (0 on tetrahedra, "
                             "1 and more on triangles)");
  }
  return checkArrayLengths(grid);
}

template <class Cell>
bool inRange(const Cell& cell, std::size_t points)
{
  return std::all_of(
    cell.begin(), cell.end(), [points](Index v) { return v >= 0 && static_cast<std::size_t>(v) < points; });
}

void readPoints(vtkUnstructuredGrid* grid, MeshData& mesh)
{
  reserveLarge(mesh.points, static_cast<std::size_t>(grid->GetNumberOfPoints()));
  mesh.points.resize(grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double x[3];
    grid->GetPoint(i, x);
    mesh.points[i] = { x[0], x[1], x[2] };
  }
}

Outcome readCells(vtkUnstructuredGrid* grid, MeshData& mesh)
{
  auto* patchIds = grid->GetCellData()->GetArray(contract::PatchId);
  reserveLarge(mesh.tetrahedra, static_cast<std::size_t>(grid->GetNumberOfCells()));
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    vtkIdType size = 0;
    const vtkIdType* v = nullptr;
    grid->GetCellPoints(c, size, v);
    const auto at = [v](int i) { return static_cast<Index>(v[i]); };
    if (size == 4)
    {
      mesh.tetrahedra.push_back({ at(0), at(1), at(2), at(3) });
      continue;
    }
    int patch = 0;
    if (Outcome outcome = readPatchId(patchIds, c, patch); !outcome.ok())
    {
      return outcome;
    }
    mesh.triangles.push_back({ at(0), at(1), at(2) });
    mesh.trianglePatch.push_back(patch);
  }
  return Outcome::done();
}

void completePatches(const MeshData& mesh, PatchTable& patches)
{
  const int largest = *std::max_element(mesh.trianglePatch.begin(), mesh.trianglePatch.end());
  for (std::size_t i = patches.size(); i <= static_cast<std::size_t>(largest); ++i)
  {
    patches.push_back({ i == 0 ? "fluid" : "patch_" + std::to_string(i), PatchType::Patch });
  }
}

template <class Array, class Value>
void addColumn(
  vtkFieldData* fieldData, const char* name, const LayerPlan& plan, Value LayerSpecification::*member)
{
  vtkNew<Array> array;
  array->SetName(name);
  for (const LayerSpecification& s : plan)
  {
    array->InsertNextValue(s.*member);
  }
  fieldData->AddArray(array);
}
template <class Cell>
void appendCells(const std::vector<Cell>& cells, vtkIdType*& offset, vtkIdType*& connectivity)
{
  for (const Cell& cell : cells)
  {
    connectivity = std::copy(cell.begin(), cell.end(), connectivity);
    offset[1] = offset[0] + static_cast<vtkIdType>(cell.size());
    ++offset;
  }
}

// Tetrahedra, then triangles. Whole arrays at once: cell by cell takes several times as long.
vtkSmartPointer<vtkCellArray> toCellArray(const MeshData& mesh)
{
  const auto tets = static_cast<vtkIdType>(mesh.tetrahedra.size());
  const auto triangles = static_cast<vtkIdType>(mesh.triangles.size());
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  vtkIdType* offset = resizeLarge(offsets.Get(), tets + triangles + 1);
  vtkIdType* next = resizeLarge(connectivity.Get(), 4 * tets + 3 * triangles);
  *offset = 0;
  appendCells(mesh.tetrahedra, offset, next);
  appendCells(mesh.triangles, offset, next);
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}
} // namespace

Outcome readMesh(vtkUnstructuredGrid* grid, MeshData& mesh, PatchTable& patches)
{
  if (Outcome outcome = checkGrid(grid); !outcome.ok())
  {
    return outcome;
  }
  mesh = {};
  readPoints(grid, mesh);
  if (Outcome outcome = readCells(grid, mesh); !outcome.ok())
  {
    return outcome;
  }
  const auto valid = [&mesh](const auto& cell) { return inRange(cell, mesh.points.size()); };
  if (std::all_of(mesh.tetrahedra.begin(), mesh.tetrahedra.end(), valid) &&
    std::all_of(mesh.triangles.begin(), mesh.triangles.end(), valid))
  {
    turnOutward(mesh, matchFaces(mesh));
  }
  patches = readPatches(grid->GetFieldData());
  completePatches(mesh, patches);
  return Outcome::done();
}

void writeMesh(const MeshData& mesh, const PatchTable& patches, vtkUnstructuredGrid* grid)
{
  grid->Initialize();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.points.size()));
  auto* coordinate = static_cast<double*>(points->GetVoidPointer(0));
  preferLargePages(coordinate, 3 * sizeof(double) * mesh.points.size());
  for (const Vector3& p : mesh.points)
  {
    for (const double x : { p.x, p.y, p.z })
    {
      *coordinate++ = x;
    }
  }
  const auto tets = static_cast<vtkIdType>(mesh.tetrahedra.size());
  const auto triangles = static_cast<vtkIdType>(mesh.triangles.size());
  vtkNew<vtkUnsignedCharArray> types;
  std::fill_n(resizeLarge(types.Get(), tets + triangles), tets, static_cast<unsigned char>(VTK_TETRA));
  std::fill_n(types->GetPointer(tets), triangles, static_cast<unsigned char>(VTK_TRIANGLE));
  vtkNew<vtkIntArray> patchIds;
  patchIds->SetName(contract::PatchId);
  std::fill_n(resizeLarge(patchIds.Get(), tets + triangles), tets, 0);
  std::copy(mesh.trianglePatch.begin(), mesh.trianglePatch.end(), patchIds->GetPointer(tets));
  grid->SetPoints(points);
  grid->SetCells(types, toCellArray(mesh));
  grid->GetCellData()->AddArray(patchIds);
  writePatches(patches, grid->GetFieldData());
}

void writePlan(const LayerPlan& plan, vtkFieldData* fieldData)
{
  addColumn<vtkDoubleArray>(fieldData, contract::LayersFirstHeight, plan, &LayerSpecification::firstHeight);
  addColumn<vtkDoubleArray>(fieldData, contract::LayersGrowthRate, plan, &LayerSpecification::growthRate);
  addColumn<vtkIntArray>(fieldData, contract::LayersNumber, plan, &LayerSpecification::numberOfLayers);
  addColumn<vtkIntArray>(fieldData, contract::LayersConstant, plan, &LayerSpecification::constantLayers);
  addColumn<vtkDoubleArray>(
    fieldData, contract::LayersIsotropicFraction, plan, &LayerSpecification::isotropicFraction);
  addColumn<vtkDoubleArray>(fieldData, contract::LayersNormalAngle, plan, &LayerSpecification::normalAngle);
  addColumn<vtkDoubleArray>(fieldData, contract::LayersFanAngle, plan, &LayerSpecification::fanAngle);
}

namespace
{
// The array's entry, where there is one.
double valueOr(vtkDataArray* array, vtkIdType row, double otherwise)
{
  return array && row < array->GetNumberOfTuples() ? array->GetTuple1(row) : otherwise;
}

// What is no count becomes one that is too large.
int countIn(vtkDataArray* array, vtkIdType row)
{
  const double value = array->GetTuple1(row);
  return value >= 0 && value <= MaximumNumberOfLayers ? static_cast<int>(value) : MaximumNumberOfLayers + 1;
}
} // namespace

LayerPlan readPlan(vtkFieldData* fieldData)
{
  vtkDataArray* first = fieldData->GetArray(contract::LayersFirstHeight);
  vtkDataArray* growth = fieldData->GetArray(contract::LayersGrowthRate);
  vtkDataArray* number = fieldData->GetArray(contract::LayersNumber);
  vtkDataArray* constant = fieldData->GetArray(contract::LayersConstant);
  vtkDataArray* fraction = fieldData->GetArray(contract::LayersIsotropicFraction);
  LayerPlan plan;
  if (!first || !growth || !number || !constant || !fraction)
  {
    return plan;
  }
  const vtkIdType rows = std::min({ first->GetNumberOfTuples(), growth->GetNumberOfTuples(),
    number->GetNumberOfTuples(), constant->GetNumberOfTuples(), fraction->GetNumberOfTuples() });
  for (vtkIdType i = 0; i < rows; ++i)
  {
    LayerSpecification s;
    s.firstHeight = first->GetTuple1(i);
    s.growthRate = growth->GetTuple1(i);
    s.numberOfLayers = countIn(number, i);
    s.constantLayers = countIn(constant, i);
    s.isotropicFraction = fraction->GetTuple1(i);
    s.normalAngle = valueOr(fieldData->GetArray(contract::LayersNormalAngle), i, s.normalAngle);
    s.fanAngle = valueOr(fieldData->GetArray(contract::LayersFanAngle), i, s.fanAngle);
    plan.push_back(s);
  }
  return plan;
}
} // namespace ransmesh

#include "MixedConversion.h"

#include "ArrayLengths.h"
#include "PatchFieldData.h"
#include "PatchNumbering.h"

#include "Support/DataContract.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>

namespace ransmesh
{
namespace
{
// Appends cells of one type.
class CellAppender
{
public:
  explicit CellAppender(vtkIdType count)
  {
    types_->Allocate(count);
    patchIds_->Allocate(count);
    patchIds_->SetName(contract::PatchId);
  }

  void add(int type, const Index* corners, int size, int patch)
  {
    cells_->InsertNextCell(size);
    for (int i = 0; i < size; ++i)
    {
      cells_->InsertCellPoint(corners[i]);
    }
    types_->InsertNextValue(static_cast<unsigned char>(type));
    patchIds_->InsertNextValue(patch);
  }

  template <class Cells>
  void addVolume(int type, const Cells& cells)
  {
    for (const auto& cell : cells)
    {
      add(type, cell.data(), static_cast<int>(cell.size()), 0);
    }
  }

  void giveTo(vtkUnstructuredGrid* grid)
  {
    grid->SetCells(types_, cells_);
    grid->GetCellData()->AddArray(patchIds_);
  }

private:
  vtkNew<vtkCellArray> cells_;
  vtkNew<vtkUnsignedCharArray> types_;
  vtkNew<vtkIntArray> patchIds_;
};

template <std::size_t Size>
std::array<Index, Size> cornersOf(const vtkIdType* v)
{
  std::array<Index, Size> corners;
  std::transform(v, v + Size, corners.begin(), [](vtkIdType i) { return static_cast<Index>(i); });
  return corners;
}

class MixedReader
{
public:
  MixedReader(vtkUnstructuredGrid* grid, MixedMesh& mesh, std::vector<Index>& boundaryIds)
    : grid_(grid)
    , patchIds_(grid->GetCellData()->GetArray(contract::PatchId))
    , mesh_(mesh)
    , boundaryIds_(boundaryIds)
  {
  }

  Outcome read(vtkIdType c)
  {
    vtkIdType size = 0;
    const vtkIdType* v = nullptr;
    grid_->GetCellPoints(c, size, v);
    switch (grid_->GetCellType(c))
    {
      case VTK_TETRA:
        return add(cornersOf<4>(v), c, mesh_.tetrahedra, tetIds);
      case VTK_PYRAMID:
        return add(cornersOf<5>(v), c, mesh_.pyramids, pyramidIds);
      case VTK_WEDGE:
        return add(cornersOf<6>(v), c, mesh_.wedges, wedgeIds);
      case VTK_HEXAHEDRON:
        return add(cornersOf<8>(v), c, mesh_.hexahedra, hexahedronIds);
      case VTK_TRIANGLE:
      {
        const auto t = cornersOf<3>(v);
        return addBoundary({ t[0], t[1], t[2], None }, c);
      }
      case VTK_QUAD:
        return addBoundary(cornersOf<4>(v), c);
      default:
        return Outcome::badInput("cell " + std::to_string(c) + " is of VTK type " +
          std::to_string(grid_->GetCellType(c)) +
          "; the mesh must hold tetrahedra, pyramids, wedges and hexahedra, and triangles and quadrilaterals "
          "on its boundary");
    }
  }

  std::vector<Index> tetIds;
  std::vector<Index> pyramidIds;
  std::vector<Index> wedgeIds;
  std::vector<Index> hexahedronIds;

private:
  template <class Cells, class Cell>
  Outcome add(const Cell& cell, vtkIdType c, Cells& cells, std::vector<Index>& ids)
  {
    cells.push_back(cell);
    ids.push_back(static_cast<Index>(c));
    return Outcome::done();
  }

  Outcome addBoundary(const Polygon& polygon, vtkIdType c)
  {
    int patch = 0;
    if (const Outcome outcome = readPatchId(patchIds_, c, patch); !outcome.ok())
    {
      return outcome;
    }
    mesh_.boundaryPatch.push_back(patch);
    return add(polygon, c, mesh_.boundary, boundaryIds_);
  }

  vtkUnstructuredGrid* grid_;
  vtkDataArray* patchIds_;
  MixedMesh& mesh_;
  std::vector<Index>& boundaryIds_;
};
} // namespace

bool isMixed(vtkUnstructuredGrid* grid)
{
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    const int type = grid->GetCellType(c);
    if (type == VTK_PYRAMID || type == VTK_WEDGE || type == VTK_HEXAHEDRON || type == VTK_QUAD)
    {
      return true;
    }
  }
  return false;
}

Outcome readMixedMesh(vtkUnstructuredGrid* grid, MixedMesh& mesh, PatchTable& patches,
  std::vector<Index>& cellIds, std::vector<Index>& boundaryIds)
{
  vtkDataArray* patchIds = grid->GetCellData()->GetArray(contract::PatchId);
  if (!patchIds || patchIds->GetNumberOfComponents() != 1)
  {
    return Outcome::badInput("the mesh has no cell array PatchId (0 on cells of the fluid, 1 and more on its "
                             "boundary)");
  }
  if (Outcome outcome = checkArrayLengths(grid); !outcome.ok())
  {
    return outcome;
  }
  if (grid->GetNumberOfPoints() > std::numeric_limits<Index>::max() / 8)
  {
    return Outcome::badInput("the mesh has too many points for 32-bit numbers");
  }
  mesh = {};
  boundaryIds.clear();
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double x[3];
    grid->GetPoint(i, x);
    mesh.points.push_back({ x[0], x[1], x[2] });
  }
  MixedReader reader(grid, mesh, boundaryIds);
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    if (Outcome outcome = reader.read(c); !outcome.ok())
    {
      return outcome;
    }
  }
  cellIds = std::move(reader.tetIds);
  cellIds.insert(cellIds.end(), reader.pyramidIds.begin(), reader.pyramidIds.end());
  cellIds.insert(cellIds.end(), reader.wedgeIds.begin(), reader.wedgeIds.end());
  cellIds.insert(cellIds.end(), reader.hexahedronIds.begin(), reader.hexahedronIds.end());
  patches = readPatches(grid->GetFieldData());
  for (const int patch : mesh.boundaryPatch)
  {
    while (patches.size() <= static_cast<std::size_t>(patch))
    {
      const std::size_t i = patches.size();
      patches.push_back({ i == 0 ? "fluid" : "patch_" + std::to_string(i), PatchType::Patch });
    }
  }
  return Outcome::done();
}

void writeMixedMesh(const MixedMesh& mesh, const PatchTable& patches, vtkUnstructuredGrid* grid)
{
  grid->Initialize();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.points.size()));
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), mesh.points[i].x, mesh.points[i].y, mesh.points[i].z);
  }
  CellAppender cells(static_cast<vtkIdType>(mesh.cellCount() + mesh.boundary.size()));
  cells.addVolume(VTK_TETRA, mesh.tetrahedra);
  cells.addVolume(VTK_PYRAMID, mesh.pyramids);
  cells.addVolume(VTK_WEDGE, mesh.wedges);
  cells.addVolume(VTK_HEXAHEDRON, mesh.hexahedra);
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
  {
    const Polygon& v = mesh.boundary[i];
    const bool isThree = isTriangle(v);
    cells.add(isThree ? VTK_TRIANGLE : VTK_QUAD, v.data(), isThree ? 3 : 4, mesh.boundaryPatch[i]);
  }
  grid->SetPoints(points);
  cells.giveTo(grid);
  writePatches(patches, grid->GetFieldData());
}
} // namespace ransmesh

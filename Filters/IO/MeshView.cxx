#include "MeshView.h"

#include "ArrayLengths.h"
#include "PatchFieldData.h"
#include "RegionArrays.h"

#include "Support/DataContract.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>
#include <map>

namespace ransmesh
{
namespace
{
constexpr auto Unknown = static_cast<CellKind>(-1);
constexpr std::array<int, 6> CornersOfKind = { 4, 5, 6, 8, 3, 4 };

bool isVolume(CellKind kind)
{
  return kind <= CellKind::Hexahedron;
}

using Point = std::array<double, 3>;

Point minus(const Point& a, const Point& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double tripleProduct(const Point& a, const Point& b, const Point& c)
{
  return (a[1] * b[2] - a[2] * b[1]) * c[0] + (a[2] * b[0] - a[0] * b[2]) * c[1] +
    (a[0] * b[1] - a[1] * b[0]) * c[2];
}

// Numbers of cells, whatever the array's type.
class CellNumbers
{
public:
  CellNumbers(vtkUnstructuredGrid* grid, const char* name)
    : array_(grid->GetCellData()->GetArray(name))
    , ints_(vtkIntArray::SafeDownCast(array_))
  {
  }

  bool present() const { return array_ && array_->GetNumberOfComponents() == 1; }
  // 0 for what is no number of a patch or region.
  int at(vtkIdType cell) const
  {
    if (ints_)
    {
      return std::max(0, ints_->GetValue(cell));
    }
    const double value = array_->GetTuple1(cell);
    const bool number = value >= 1 && value < std::numeric_limits<int>::max();
    return number && value == static_cast<int>(value) ? static_cast<int>(value) : 0;
  }

private:
  vtkDataArray* array_;
  vtkIntArray* ints_;
};
} // namespace

const std::array<CellKind, 256> MeshView::kinds_ = []
{
  std::array<CellKind, 256> kinds;
  kinds.fill(Unknown);
  kinds[VTK_TETRA] = CellKind::Tetrahedron;
  kinds[VTK_PYRAMID] = CellKind::Pyramid;
  kinds[VTK_WEDGE] = CellKind::Wedge;
  kinds[VTK_HEXAHEDRON] = CellKind::Hexahedron;
  kinds[VTK_TRIANGLE] = CellKind::Triangle;
  kinds[VTK_QUAD] = CellKind::Quadrilateral;
  return kinds;
}();

Outcome MeshView::make(vtkUnstructuredGrid* grid, MeshView& view)
{
  view = {};
  if (!grid || grid->GetNumberOfPoints() == 0 || grid->GetNumberOfCells() == 0)
  {
    return Outcome::badInput("the input is empty: connect a mesh");
  }
  for (const auto& step : { +[](MeshView&v, vtkUnstructuredGrid*g) { return v.readArrays(g); },
         +[](MeshView&v, vtkUnstructuredGrid*) { return v.countCells(); },
         +[](MeshView&v, vtkUnstructuredGrid*g) { return v.readPatches(g); },
         +[](MeshView&v, vtkUnstructuredGrid*g) { return v.readRegions(g); } })
  {
    if (Outcome outcome = step(view, grid); !outcome.ok())
    {
      return outcome;
    }
  }
  view.findSheets();
  return Outcome::done();
}

Outcome MeshView::readArrays(vtkUnstructuredGrid* grid)
{
  points_ = grid->GetPoints();
  pointCount_ = points_->GetNumberOfPoints();
  if (auto* doubles = vtkDoubleArray::SafeDownCast(points_->GetData()))
  {
    doubles_ = doubles->GetPointer(0);
  }
  gridCells_ = grid->GetNumberOfCells();
  types_ = grid->GetCellTypesArray()->GetPointer(0);
  vtkCellArray* cells = grid->GetCells();
  if (cells->IsStorage64Bit())
  {
    offsets64_ = cells->GetOffsetsArray64()->GetPointer(0);
    connectivity64_ = cells->GetConnectivityArray64()->GetPointer(0);
  }
  else
  {
    offsets32_ = cells->GetOffsetsArray32()->GetPointer(0);
    connectivity32_ = cells->GetConnectivityArray32()->GetPointer(0);
  }
  return Outcome::done();
}

std::array<double, 3> MeshView::point(vtkIdType i) const
{
  std::array<double, 3> x;
  if (doubles_)
  {
    std::copy_n(doubles_ + 3 * i, 3, x.data());
  }
  else
  {
    points_->GetPoint(i, x.data());
  }
  return x;
}

Corners MeshView::corners(vtkIdType id) const
{
  Corners cell;
  cell.kind = kinds_[types_[id]];
  if (offsets64_)
  {
    const vtkTypeInt64 start = offsets64_[id];
    cell.count = static_cast<int>(offsets64_[id + 1] - start);
    std::copy_n(connectivity64_ + start, cell.count, cell.points.data());
  }
  else
  {
    const vtkTypeInt32 start = offsets32_[id];
    cell.count = offsets32_[id + 1] - start;
    std::copy_n(connectivity32_ + start, cell.count, cell.points.data());
  }
  return cell;
}

// Tetrahedra are positive by the data contract, exactly; what a mesh has else is far from flat.
Corners MeshView::turned(Corners cell) const
{
  if (cell.kind == CellKind::Tetrahedron)
  {
    return cell;
  }
  const Point origin = point(cell[0]);
  const Point first = minus(point(cell[1]), origin);
  const Point last = minus(point(cell[cell.kind == CellKind::Wedge ? 2 : 3]), origin);
  Point up = { 0, 0, 0 }; // from the first face to the opposite one, or to the apex
  const int base = cell.kind == CellKind::Wedge ? 3 : 4;
  for (int i = base; i < cell.count; ++i)
  {
    const Point edge = minus(point(cell[i]), point(cell[i - base]));
    up = { up[0] + edge[0], up[1] + edge[1], up[2] + edge[2] };
  }
  if (tripleProduct(first, last, up) < 0)
  {
    std::swap(cell.points[1], cell.points[base - 1]);
    if (cell.kind != CellKind::Pyramid)
    {
      std::swap(cell.points[base + 1], cell.points[cell.count - 1]);
    }
  }
  return cell;
}

Outcome MeshView::checkCell(vtkIdType id) const
{
  const CellKind kind = kinds_[types_[id]];
  const auto where = [id] { return "cell " + std::to_string(id); };
  if (kind == Unknown)
  {
    return Outcome::badInput(where() + " is of VTK type " + std::to_string(types_[id]) +
      "; solvers' meshes hold tetrahedra, pyramids, wedges and hexahedra, and triangles and quadrilaterals "
      "of "
      "the boundary: leave out or convert the others");
  }
  const vtkIdType size =
    offsets64_ ? offsets64_[id + 1] - offsets64_[id] : offsets32_[id + 1] - offsets32_[id];
  if (size != CornersOfKind[static_cast<int>(kind)])
  {
    return Outcome::badInput(where() + " has " + std::to_string(size) + " points, too many or too few");
  }
  const Corners cell = corners(id);
  if (std::any_of(cell.begin(), cell.end(), [this](vtkIdType p) { return p < 0 || p >= pointCount_; }))
  {
    return Outcome::badInput(where() + " has a point number that there is no point for");
  }
  return Outcome::done();
}

Outcome MeshView::countCells()
{
  vtkIdType lastVolume = -1;
  vtkIdType faces = 0;
  for (vtkIdType id = 0; id < gridCells_; ++id)
  {
    if (Outcome outcome = checkCell(id); !outcome.ok())
    {
      return outcome;
    }
    const CellKind kind = kinds_[types_[id]];
    ++kindCounts_[static_cast<int>(kind)];
    (isVolume(kind) ? cellCount_ : faces) += 1;
    lastVolume = isVolume(kind) ? id : lastVolume;
  }
  if (cellCount_ == 0)
  {
    return Outcome::badInput("the mesh has no volume cells: a surface alone is not a mesh for a solver");
  }
  faceIds_.reserve(faces);
  const bool mixed = lastVolume != cellCount_ - 1;
  for (vtkIdType id = mixed ? 0 : cellCount_; id < gridCells_; ++id)
  {
    if (!isVolume(kinds_[types_[id]]))
    {
      faceIds_.push_back(id);
    }
    else
    {
      cellIds_.push_back(id);
    }
  }
  return Outcome::done();
}

Outcome MeshView::readPatches(vtkUnstructuredGrid* grid)
{
  if (Outcome outcome = checkArrayLengths(grid); !outcome.ok())
  {
    return outcome;
  }
  const CellNumbers numbers(grid, contract::PatchId);
  if (faceIds_.empty() || !numbers.present())
  {
    return Outcome::badInput("the mesh has no boundary faces with a cell array PatchId (1 and more on the "
                             "triangles and quadrilaterals): a solver could not tell its boundaries");
  }
  const PatchTable table = ransmesh::readPatches(grid->GetFieldData());
  std::map<int, BoundaryPatch> patches;
  for (const vtkIdType id : faceIds_)
  {
    const int number = numbers.at(id);
    if (number == 0)
    {
      return Outcome::badInput(
        "face " + std::to_string(id) + " has no PatchId; boundary faces need a whole number of 1 or more");
    }
    BoundaryPatch& patch = patches[number];
    (kinds_[types_[id]] == CellKind::Triangle ? patch.triangles : patch.quadrilaterals) += 1;
  }
  const auto byPatch = [&numbers](vtkIdType a, vtkIdType b) { return numbers.at(a) < numbers.at(b); };
  if (!std::is_sorted(faceIds_.begin(), faceIds_.end(), byPatch))
  {
    std::stable_sort(faceIds_.begin(), faceIds_.end(), byPatch);
  }
  vtkIdType first = 0;
  for (auto& [number, patch] : patches)
  {
    const bool named = static_cast<std::size_t>(number) < table.size();
    patch.id = number;
    patch.first = first;
    patch.name =
      named && !table[number].name.empty() ? table[number].name : "patch_" + std::to_string(number);
    patch.type = named ? table[number].type : PatchType::Patch;
    first += patch.count();
    patches_.push_back(patch);
  }
  fluidName_ = table.empty() || table[0].name.empty() ? "fluid" : table[0].name;
  return Outcome::done();
}

Outcome MeshView::readRegions(vtkUnstructuredGrid* grid)
{
  const CellNumbers numbers(grid, contract::RegionId);
  std::map<int, Region> found;
  int last = -1; // cells of one region mostly follow one another
  Region* region = nullptr;
  for (vtkIdType i = 0; numbers.present() && i < cellCount_; ++i)
  {
    const int id = numbers.at(gridCell(i));
    region = id == last ? region : &found[id];
    last = id;
    ++region->cells[static_cast<int>(kindOfCell(i))];
  }
  if (found.size() > std::numeric_limits<std::uint16_t>::max())
  {
    return Outcome::badInput("the mesh has " + std::to_string(found.size()) +
      " regions (cell array RegionId), more than can be written: leave the array out");
  }
  if (found.size() < 2 || found.contains(0)) // 0: not all cells are of a region
  {
    const std::array<vtkIdType, 4> counts = { kindCounts_[0], kindCounts_[1], kindCounts_[2],
      kindCounts_[3] };
    regions_ = { { 1, fluidName_, counts } };
    return Outcome::done();
  }
  std::map<int, std::uint16_t> placeOf;
  for (auto& [id, one] : found)
  {
    one.id = id;
    one.name = regionName(grid->GetFieldData(), id, fluidName_);
    placeOf[id] = static_cast<std::uint16_t>(regions_.size());
    regions_.push_back(std::move(one));
  }
  cellRegions_.reserve(cellCount_);
  for (vtkIdType i = 0; i < cellCount_; ++i)
  {
    cellRegions_.push_back(placeOf[numbers.at(gridCell(i))]);
  }
  return Outcome::done();
}

// No patch is a sheet in one part and outer boundary in another: one face of each tells.
void MeshView::findSheets()
{
  std::vector<bool> probed(pointCount_); // points of the first face of each patch
  for (const BoundaryPatch& patch : patches_)
  {
    const Corners probe = face(patch.first);
    std::for_each(probe.begin(), probe.end(), [&probed](vtkIdType p) { probed[p] = true; });
  }
  std::vector<std::vector<std::size_t>> regionsAt(patches_.size()); // of the cells at each probe
  for (vtkIdType i = 0; i < cellCount_; ++i)
  {
    const Corners cell = unturnedCell(i);
    if (std::count_if(cell.begin(), cell.end(), [&probed](vtkIdType p) { return probed[p]; }) < 3)
    {
      continue;
    }
    for (std::size_t p = 0; p < patches_.size(); ++p)
    {
      const Corners probe = face(patches_[p].first);
      const bool held = std::all_of(probe.begin(), probe.end(),
        [&cell](vtkIdType v) { return std::find(cell.begin(), cell.end(), v) != cell.end(); });
      if (held)
      {
        regionsAt[p].push_back(regionOf(i));
      }
    }
  }
  for (std::size_t p = 0; p < patches_.size(); ++p)
  {
    patches_[p].inside = regionsAt[p].size() > 1;
    patches_[p].divides = patches_[p].inside && regionsAt[p][0] != regionsAt[p][1];
  }
}

void MeshView::leaveOutSheets(bool dividingOnesToo)
{
  std::vector<vtkIdType> kept;
  std::vector<BoundaryPatch> outer;
  for (BoundaryPatch patch : patches_)
  {
    if (!patch.inside || (patch.divides && !dividingOnesToo))
    {
      const auto from = faceIds_.begin() + patch.first;
      patch.first = static_cast<vtkIdType>(kept.size());
      kept.insert(kept.end(), from, from + patch.count());
      outer.push_back(patch);
      continue;
    }
    kindCounts_[static_cast<int>(CellKind::Triangle)] -= patch.triangles;
    kindCounts_[static_cast<int>(CellKind::Quadrilateral)] -= patch.quadrilaterals;
  }
  faceIds_.swap(kept);
  patches_.swap(outer);
}
} // namespace ransmesh

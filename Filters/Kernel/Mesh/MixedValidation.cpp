#include "Mesh/MixedValidation.h"

#include "Geometry/Predicates.h"
#include "Support/FaultList.h"

#include <algorithm>
#include <set>

namespace ransmesh
{
namespace
{
constexpr Index NoCell = -1;

// A face as one cell or one boundary polygon has it.
struct FaceUse
{
  Polygon key;    // the lowest point first, then in the sense that has the lower second point
  bool isReverse; // the face runs against the key
  Index cell;     // NoCell: of a boundary polygon
  Index polygon;
};

FaceUse makeUse(const Polygon& face, Index cell, Index polygon)
{
  const int n = isTriangle(face) ? 3 : 4;
  const auto lowest = static_cast<int>(std::min_element(face.begin(), face.begin() + n) - face.begin());
  const auto at = [&](int i) { return face[(lowest + i + n) % n]; };
  const bool isReverse = at(-1) < at(1);
  const int step = isReverse ? -1 : 1;
  FaceUse use{ { at(0), at(step), at(2 * step), None }, isReverse, cell, polygon };
  if (n == 4)
  {
    use.key[3] = at(3 * step);
  }
  return use;
}

template <class Cells>
void addUses(const Cells& cells, Index first, std::vector<FaceUse>& uses)
{
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    for (const Polygon& face : facesOf(cells[i]))
    {
      uses.push_back(makeUse(face, first + static_cast<Index>(i), None));
    }
  }
}

// All uses of all faces, equal faces side by side, cells before polygons.
std::vector<FaceUse> collectUses(const MixedMesh& mesh)
{
  std::vector<FaceUse> uses;
  uses.reserve(4 * mesh.tetrahedra.size() + 5 * (mesh.pyramids.size() + mesh.wedges.size()) +
    6 * mesh.hexahedra.size() + mesh.boundary.size());
  const auto tets = static_cast<Index>(mesh.tetrahedra.size());
  addUses(mesh.tetrahedra, 0, uses);
  addUses(mesh.pyramids, tets, uses);
  addUses(mesh.wedges, tets + static_cast<Index>(mesh.pyramids.size()), uses);
  addUses(mesh.hexahedra, tets + static_cast<Index>(mesh.pyramids.size() + mesh.wedges.size()), uses);
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
  {
    uses.push_back(makeUse(mesh.boundary[i], NoCell, static_cast<Index>(i)));
  }
  std::sort(uses.begin(), uses.end(),
    [](const FaceUse& a, const FaceUse& b)
    { return a.key != b.key ? a.key < b.key : (a.cell == NoCell) < (b.cell == NoCell); });
  return uses;
}

class FaceCheck
{
public:
  FaceCheck(const MixedMesh& mesh, MixedFaults& faults)
    : mesh_(mesh)
    , faults_(faults)
  {
  }

  void run()
  {
    const std::vector<FaceUse> uses = collectUses(mesh_);
    for (std::size_t begin = 0; begin < uses.size();)
    {
      std::size_t end = begin + 1;
      while (end < uses.size() && uses[end].key == uses[begin].key)
      {
        ++end;
      }
      checkFace(&uses[begin], &uses[begin] + (end - begin));
      begin = end;
    }
    for (const Index polygon : inside_) // right where all of their patch are so: a sheet
    {
      faults_.polygonsOffTheBoundary += onBoundary_.contains(mesh_.boundaryPatch[polygon]);
    }
  }

private:
  void note(std::size_t& counter, Index cell)
  {
    ++counter;
    faults_.firstCell = faults_.firstCell == None ? cell : faults_.firstCell;
  }

  void checkFace(const FaceUse* begin, const FaceUse* end)
  {
    const FaceUse* split = std::find_if(begin, end, [](const FaceUse& use) { return use.cell == NoCell; });
    const auto cells = split - begin;
    const auto polygons = end - split;
    faults_.polygonsRepeated += polygons > 1 ? 1 : 0;
    if (cells == 0)
    {
      ++faults_.polygonsOffTheBoundary;
    }
    else if (cells > 2)
    {
      note(faults_.facesOfMoreCells, begin->cell);
    }
    else if (cells == 2)
    {
      checkInner(begin, split, end);
    }
    else if (polygons == 0)
    {
      note(faults_.facesAlone, begin->cell);
    }
    else
    {
      onBoundary_.insert(mesh_.boundaryPatch[split->polygon]);
      faults_.polygonsTurnedInward += split->isReverse != begin->isReverse;
    }
  }

  void checkInner(const FaceUse* begin, const FaceUse* split, const FaceUse* end)
  {
    if (begin[0].isReverse == begin[1].isReverse)
    {
      note(faults_.facesTurnedAlike, begin->cell);
    }
    for (const FaceUse* use = split; use != end; ++use)
    {
      inside_.push_back(use->polygon);
    }
  }

  const MixedMesh& mesh_;
  MixedFaults& faults_;
  std::set<int> onBoundary_;
  std::vector<Index> inside_;
};

template <class Cells>
std::size_t countOutOfRange(const Cells& cells, std::size_t points, bool mayBeShort = false)
{
  return static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(),
    [&](const auto& cell)
    {
      return std::any_of(cell.begin(), cell.end(),
        [&](const Index& v)
        {
          const bool isLeftOut = mayBeShort && v == None && &v == &cell.back();
          return !isLeftOut && (v < 0 || static_cast<std::size_t>(v) >= points);
        });
    }));
}

template <class Cells, class Sound>
void checkCells(const Cells& cells, Index first, Sound isRight, MixedFaults& faults)
{
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    if (!isRight(cells[i]))
    {
      ++faults.cellsNotSound;
      faults.firstCell = faults.firstCell == None ? first + static_cast<Index>(i) : faults.firstCell;
    }
  }
}

void checkShapes(const MixedMesh& mesh, MixedFaults& faults)
{
  const auto& p = mesh.points;
  const auto tets = static_cast<Index>(mesh.tetrahedra.size());
  checkCells(
    mesh.tetrahedra, 0, [&p](const auto& v) { return isPositive(p[v[0]], p[v[1]], p[v[2]], p[v[3]]); },
    faults);
  checkCells(
    mesh.pyramids, tets, [&p](const Pyramid& v) { return isSound(v, p); }, faults);
  checkCells(
    mesh.wedges, tets + static_cast<Index>(mesh.pyramids.size()),
    [&p](const Wedge& v) { return isSound(v, p); }, faults);
  checkCells(
    mesh.hexahedra, tets + static_cast<Index>(mesh.pyramids.size() + mesh.wedges.size()),
    [&p](const Hexahedron& v) { return isSound(v, p); }, faults);
}
} // namespace

bool MixedFaults::none() const
{
  return !indicesOutOfRange && !pointsNotFinite && !cellsNotSound && !facesAlone && !facesOfMoreCells &&
    !facesTurnedAlike && !polygonsOffTheBoundary && !polygonsRepeated && !polygonsTurnedInward;
}

std::string MixedFaults::text() const
{
  FaultList list;
  list.add(indicesOutOfRange, "cells with point numbers out of range");
  list.add(pointsNotFinite, "points not finite");
  list.add(cellsNotSound, "cells with a corner that is not positive");
  list.add(facesAlone, "faces with nothing on their other side");
  list.add(facesOfMoreCells, "faces of more than two cells");
  list.add(facesTurnedAlike, "faces whose two cells lie on one side");
  list.add(polygonsOffTheBoundary, "boundary faces off the boundary");
  list.add(polygonsRepeated, "repeated boundary faces");
  list.add(polygonsTurnedInward, "boundary faces turned inward");
  std::string out = list.text();
  if (firstCell != None)
  {
    out += "; first cell " + std::to_string(firstCell);
  }
  return out;
}

MixedFaults findFaults(const MixedMesh& mesh)
{
  MixedFaults faults;
  const std::size_t points = mesh.points.size();
  faults.indicesOutOfRange = countOutOfRange(mesh.tetrahedra, points) +
    countOutOfRange(mesh.pyramids, points) + countOutOfRange(mesh.wedges, points) +
    countOutOfRange(mesh.hexahedra, points) + countOutOfRange(mesh.boundary, points, true);
  faults.pointsNotFinite = static_cast<std::size_t>(
    std::count_if(mesh.points.begin(), mesh.points.end(), [](const Vector3& x) { return !isFinite(x); }));
  if (faults.indicesOutOfRange || faults.pointsNotFinite)
  {
    return faults;
  }
  checkShapes(mesh, faults);
  FaceCheck(mesh, faults).run();
  return faults;
}
} // namespace ransmesh

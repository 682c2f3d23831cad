#include "FaceOrder.h"

namespace ransmesh
{
namespace
{
constexpr std::uint32_t Nothing = FaceChains::None;
constexpr std::uint32_t Boundary = Nothing - 1;
constexpr vtkIdType SmallestPart = 1000;
constexpr vtkIdType Parts = 9;

template <class Points>
bool allMarked(const Points& points, const std::vector<bool>& marks)
{
  return std::all_of(points.begin(), points.end(), [&marks](vtkIdType p) { return marks[p]; });
}
} // namespace

FaceOrder::FaceOrder(const MeshView& mesh)
  : mesh_(mesh)
{
  for (const CellKind kind : VolumeKinds)
  {
    if (mesh.numberOfCells(kind) > 0)
    {
      stride_ = std::max<std::uint32_t>(stride_, facesOf(kind));
    }
  }
  sides_.reserve(mesh.numberOfFaces());
  for (const BoundaryPatch& patch : mesh.patches())
  {
    sides_.insert(sides_.end(), patch.count(), static_cast<unsigned char>(sidesOf(patch)));
    hasSheets_ = hasSheets_ || sidesOf(patch) == 0;
  }
}

vtkIdType FaceOrder::internalFaces(int corners) const
{
  vtkIdType halfFaces = 0;
  for (const CellKind kind : VolumeKinds)
  {
    for (int f = 0; f < facesOf(kind); ++f)
    {
      const bool triangle = FacesOfKind[static_cast<int>(kind)].corners[f][3] < 0;
      halfFaces += triangle == (corners == 3) ? mesh_.numberOfCells(kind) : 0;
    }
  }
  for (const BoundaryPatch& patch : mesh_.patches())
  {
    halfFaces -= sidesOf(patch) * (corners == 3 ? patch.triangles : patch.quadrilaterals);
  }
  return halfFaces / 2;
}

void FaceOrder::enterBoundary()
{
  owners_.assign(mesh_.numberOfFaces(), { Nothing, Nothing });
  boundary_.reset(mesh_.numberOfPoints(), mesh_.numberOfFaces());
  for (vtkIdType f = 0; f < mesh_.numberOfFaces(); ++f)
  {
    boundary_.insert(keyOf(mesh_.face(f)), static_cast<std::uint32_t>(f));
  }
}

// Notes the cell behind a boundary face. A third one stays out, which the count tells at the end.
bool FaceOrder::takenByBoundary(const FaceKey& key, vtkIdType cell)
{
  const std::uint32_t face = boundary_.find(key);
  if (face == Nothing || sides_[face] == 0)
  {
    return false;
  }
  const int side = owners_[face][0] == Nothing ? 0 : 1;
  if (side < sides_[face])
  {
    owners_[face][side] = static_cast<std::uint32_t>(cell);
  }
  return true;
}

void FaceOrder::matchWithin(const Part& part)
{
  const std::size_t count = static_cast<std::size_t>(part.last - part.first) * stride_;
  halfFaces_.reset(mesh_.numberOfPoints(), count);
  neighbours_.assign(count, Nothing);
  for (vtkIdType c = part.first; c < part.last; ++c)
  {
    const Corners cell = mesh_.cell(c);
    for (int f = 0; f < facesOf(cell.kind); ++f)
    {
      const FaceKey key = keyOf(faceOf(cell, f));
      const auto half = static_cast<std::uint32_t>((c - part.first) * stride_ + f);
      if (takenByBoundary(key, c))
      {
        neighbours_[half] = Boundary;
        continue;
      }
      const std::uint32_t other = halfFaces_.take(key);
      if (other == Nothing)
      {
        halfFaces_.insert(key, half);
        continue;
      }
      neighbours_[other] = static_cast<std::uint32_t>(c);
      neighbours_[half] = static_cast<std::uint32_t>(part.first + other / stride_);
    }
  }
}

void FaceOrder::markOpen(const Part& part)
{
  open_.assign(mesh_.numberOfPoints(), false);
  for (vtkIdType c = part.first; c < part.last; ++c)
  {
    const Corners cell = mesh_.cell(c);
    for (int f = 0; f < facesOf(cell.kind); ++f)
    {
      if (neighbours_[(c - part.first) * stride_ + f] == Nothing)
      {
        const Face face = faceOf(cell, f);
        std::for_each(face.begin(), face.end(), [this](vtkIdType p) { open_[p] = true; });
      }
    }
  }
}

void FaceOrder::matchLater(const Part& part)
{
  for (vtkIdType c = part.last; c < mesh_.numberOfCells(); ++c)
  {
    const Corners cell = mesh_.unturnedCell(c);
    if (std::count_if(cell.begin(), cell.end(), [this](vtkIdType p) { return open_[p]; }) < 3)
    {
      continue;
    }
    for (int f = 0; f < facesOf(cell.kind); ++f)
    {
      const Face face = faceOf(cell, f);
      const std::uint32_t half = allMarked(face, open_) ? halfFaces_.take(keyOf(face)) : Nothing;
      if (half != Nothing)
      {
        neighbours_[half] = static_cast<std::uint32_t>(c);
      }
    }
  }
}

void FaceOrder::emit(const Part& part, const std::function<void(const InternalFace&)>& act)
{
  for (vtkIdType c = part.first; c < part.last; ++c)
  {
    const Corners cell = mesh_.cell(c);
    std::array<std::pair<std::uint32_t, int>, 6> upper;
    auto end = upper.begin();
    for (int f = 0; f < facesOf(cell.kind); ++f)
    {
      const std::uint32_t neighbour = neighbours_[(c - part.first) * stride_ + f];
      if (neighbour < Boundary && neighbour > static_cast<std::uint32_t>(c))
      {
        const std::pair entry(neighbour, f);
        const auto place = std::upper_bound(upper.begin(), end, entry);
        std::move_backward(place, end, end + 1);
        *place = entry;
        ++end;
      }
    }
    for (auto it = upper.begin(); it != end; ++it)
    {
      const Face face = faceOf(cell, it->second);
      const std::uint32_t sheet = hasSheets_ ? boundary_.find(keyOf(face)) : Nothing;
      act({ face, c, it->first, sheet == Nothing ? -1 : static_cast<vtkIdType>(sheet) });
      ++emitted_;
    }
  }
}

Outcome FaceOrder::forEachInternalFace(const std::function<void(const InternalFace&)>& act)
{
  const vtkIdType cells = mesh_.numberOfCells();
  if (cells >= Boundary / 6)
  {
    return Outcome::badInput("the mesh has too many cells for 32-bit numbers of faces");
  }
  enterBoundary();
  const vtkIdType step = std::max(SmallestPart, (cells * 4 / stride_ + Parts - 1) / Parts);
  for (vtkIdType first = 0; first < cells; first += step)
  {
    const Part part{ first, std::min(cells, first + step) };
    matchWithin(part);
    markOpen(part);
    matchLater(part);
    emit(part, act);
  }
  return checkComplete();
}

Outcome FaceOrder::checkComplete() const
{
  vtkIdType unowned = 0;
  for (std::size_t f = 0; f < owners_.size(); ++f)
  {
    for (int side = 0; side < sides_[f]; ++side)
    {
      unowned += owners_[f][side] == Nothing;
    }
  }
  const vtkIdType missing = internalFaces(3) + internalFaces(4) - emitted_;
  if (unowned == 0 && missing == 0)
  {
    return Outcome::done();
  }
  return Outcome::badInput("the mesh is not conforming: " + std::to_string(unowned) +
    " boundary faces are no cell's face, and " + std::to_string(missing) +
    " more faces of cells than there should be have no cell on their other side; vtkMeshQualityReport says "
    "what "
    "is wrong with a mesh of tetrahedra");
}

FaceOrder::OuterFace FaceOrder::outerFace(vtkIdType viewFace, int side) const
{
  const FaceKey key = keyOf(mesh_.face(viewFace));
  const std::uint32_t owner = owners_[viewFace][side];
  const Corners cell = mesh_.cell(owner);
  int f = 0;
  while (f + 1 < facesOf(cell.kind) && !(keyOf(faceOf(cell, f)) == key))
  {
    ++f;
  }
  return { faceOf(cell, f), owner };
}
} // namespace ransmesh

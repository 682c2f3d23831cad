#include "Improvement/GrowingCavity.h"

#include "Geometry/TetrahedronMeasures.h"

#include <algorithm>
#include <limits>

namespace ransmesh
{
double qualityOf(const TetMesh& mesh, Index t)
{
  const auto& v = mesh.tet(t).vertex;
  return quality(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3]));
}

bool BoundaryRules::mayStar(int patch, Index apex) const
{
  const auto own = classification.patchesAt(apex);
  return changeable[patch] && std::find(own.begin(), own.end(), patch) != own.end();
}

void GrowingCavity::begin(std::span<const Index> tets, std::initializer_list<Index> vanishing)
{
  cavity_.tets.assign(tets.begin(), tets.end());
  cavity_.starredFaces.clear();
  faces_.clear();
  inCavity_.clear(mesh_.tetSlots());
  for (const Index t : tets)
  {
    inCavity_.set(t);
  }
  for (const Index t : tets)
  {
    addOuterFaces(t, { vanishing.begin(), vanishing.size() });
  }
  tetsAtBegin_ = cavity_.tets.size();
  facesAtBegin_ = faces_.size();
  starredAtBegin_ = cavity_.starredFaces.size();
}

void GrowingCavity::addOuterFaces(Index t, std::span<const Index> vanishing)
{
  const Tetrahedron& tet = mesh_.tet(t);
  for (int f = 0; f < 4; ++f)
  {
    const HalfFace beyond = tet.neighbour[f];
    if (!isBoundary(beyond) && inCavity_.test(tetOf(beyond)))
    {
      continue;
    }
    OuterFace face{ tet.face(f), beyond, false, 0 };
    face.starred = isBoundary(beyond) && !vanishing.empty() &&
      std::all_of(vanishing.begin(), vanishing.end(), [&](Index v) { return face.has(v); });
    if (face.starred)
    {
      cavity_.starredFaces.push_back(boundaryFaceOf(beyond));
    }
    faces_.push_back(face);
  }
}

void GrowingCavity::undoGrowth()
{
  for (std::size_t i = tetsAtBegin_; i < cavity_.tets.size(); ++i)
  {
    inCavity_.unset(cavity_.tets[i]);
  }
  cavity_.tets.resize(tetsAtBegin_);
  faces_.resize(facesAtBegin_);
  if (cavity_.starredFaces.size() == starredAtBegin_)
  {
    return;
  }
  const std::span<const Index> starredLater(
    cavity_.starredFaces.begin() + static_cast<std::ptrdiff_t>(starredAtBegin_), cavity_.starredFaces.end());
  for (OuterFace& face : faces_)
  {
    const bool undone = face.starred &&
      std::find(starredLater.begin(), starredLater.end(), boundaryFaceOf(face.beyond)) != starredLater.end();
    face.starred = face.starred && !undone;
  }
  cavity_.starredFaces.resize(starredAtBegin_);
}

double GrowingCavity::qualityFrom(const OuterFace& face, const Vector3& apex) const
{
  return measure_(
    mesh_.point(face.vertex[0]), mesh_.point(face.vertex[1]), mesh_.point(face.vertex[2]), apex);
}

double GrowingCavity::worstFrom(Index apex, double floor)
{
  undoGrowth();
  const Vector3& point = mesh_.point(apex);
  double worst = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < faces_.size(); ++i)
  {
    if (faces_[i].starred || faces_[i].has(apex))
    {
      continue;
    }
    worst = std::min(worst, qualityFrom(faces_[i], point));
    if (worst <= floor)
    {
      std::swap(faces_[i], faces_[i / 2]); // faces that refuse often are asked first
      return worst;
    }
  }
  return worst;
}

std::size_t GrowingCavity::countPoor(Index apex, double floor)
{
  undoGrowth();
  const Vector3& point = mesh_.point(apex);
  return static_cast<std::size_t>(std::count_if(faces_.begin(), faces_.end(),
    [&](const OuterFace& face)
    { return !face.starred && !face.has(apex) && qualityFrom(face, point) <= floor; }));
}

// Whether outer face i can stay, or the cavity can grow beyond it.
bool GrowingCavity::passFace(std::size_t i, Index apex, double floor, std::size_t limit)
{
  OuterFace& face = faces_[i];
  const bool inner = !isBoundary(face.beyond) && inCavity_.test(tetOf(face.beyond));
  if (inner || face.starred || face.has(apex))
  {
    return true;
  }
  face.quality = qualityFrom(face, mesh_.point(apex));
  if (face.quality > floor)
  {
    return true;
  }
  if (isBoundary(face.beyond))
  {
    face.starred = rules_.mayStar(mesh_.patchOf(face.beyond), apex);
    if (face.starred)
    {
      cavity_.starredFaces.push_back(boundaryFaceOf(face.beyond));
    }
    return face.starred;
  }
  if (cavity_.tets.size() >= limit)
  {
    return false;
  }
  const Index added = tetOf(face.beyond);
  inCavity_.set(added);
  cavity_.tets.push_back(added);
  addOuterFaces(added, {});
  return true;
}

double GrowingCavity::grow(Index apex, double floor, std::size_t budget)
{
  undoGrowth();
  const std::size_t limit = tetsAtBegin_ + budget;
  for (std::size_t i = 0; i < faces_.size(); ++i)
  {
    if (!passFace(i, apex, floor, limit))
    {
      return floor;
    }
  }
  return worstOfOuterFaces(apex);
}

double GrowingCavity::worstOfOuterFaces(Index apex) const
{
  double worst = std::numeric_limits<double>::infinity();
  for (const OuterFace& face : faces_)
  {
    const bool inner = !isBoundary(face.beyond) && inCavity_.test(tetOf(face.beyond));
    if (!inner && !face.starred && !face.has(apex))
    {
      worst = std::min(worst, face.quality);
    }
  }
  return worst;
}
} // namespace ransmesh

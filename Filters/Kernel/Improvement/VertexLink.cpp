#include "Improvement/VertexLink.h"

#include "Geometry/Predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ransmesh
{
void VertexLink::turnTo(Index v)
{
  inBall_.clear();
  inGrown_.clear();
  numbers_.clear();
  centre_ = mesh_.point(v);
  ends_.clear();
  places_.clear();
  faces_.clear();
  viewed_ = 0;
  grown_.clear();
  starred_.clear();
  collectBall(v);
  endsAtV_ = ends_.size();
}

void VertexLink::collectBall(Index v)
{
  ball_.assign(1, mesh_.tetAt(v));
  inBall_.set(ball_.front());
  for (std::size_t i = 0; i < ball_.size(); ++i)
  {
    const Tetrahedron& tet = mesh_.tet(ball_[i]);
    const int cornerOfV = tet.cornerOf(v);
    for (int f = 0; f < 4; ++f)
    {
      const HalfFace other = tet.neighbour[f];
      if (f != cornerOfV && !isBoundary(other) && inBall_.set(tetOf(other)))
      {
        mesh_.fetchAhead(tetOf(other));
        ball_.push_back(tetOf(other));
      }
    }
    addFace(tet, cornerOfV);
  }
  placeNewEnds();
}

int VertexLink::localNumber(Index end)
{
  const int number = numbers_.add(end);
  if (number == static_cast<int>(ends_.size()))
  {
    ends_.push_back(end);
    mesh_.fetchPointAhead(end);
  }
  return number;
}

// After faces have been added: all at once, so that none has to be waited for alone.
void VertexLink::placeNewEnds()
{
  for (std::size_t i = places_.size(); i < ends_.size(); ++i)
  {
    places_.push_back(mesh_.point(ends_[i]) - centre_);
  }
  for (; viewed_ < faces_.size(); ++viewed_)
  {
    Face& face = faces_[viewed_];
    face.view = { places_[face.corner[0]], places_[face.corner[1]], places_[face.corner[2]] };
  }
}

// The face opposite to a corner.
void VertexLink::addFace(const Tetrahedron& tet, int corner)
{
  Face face;
  face.beyond = tet.neighbour[corner];
  for (int j = 0; j < 3; ++j)
  {
    face.corner[j] = localNumber(tet.vertex[FaceCorners[corner][j]]);
  }
  faces_.push_back(face);
}

double VertexLink::worst() const
{
  double worst = std::numeric_limits<double>::infinity();
  for (const Face& face : faces_)
  {
    worst = std::min(worst, face.view.signedSquare({}, 0));
  }
  return signedRoot(worst);
}

double VertexLink::worstFrom(int apex, double floor)
{
  undoGrowth();
  const Vector3 place = places_[apex];
  const double squareOfApex = dot(place, place);
  const double floorSquare = floor * std::fabs(floor);
  double worst = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < faces_.size(); ++i)
  {
    const Face& face = faces_[i];
    if (face.has(apex))
    {
      continue;
    }
    worst = std::min(worst, face.view.signedSquare(place, squareOfApex));
    if (!(worst > floorSquare))
    {
      std::swap(faces_[i], faces_[i / 2]); // faces that refuse often are asked first
      return floor;
    }
  }
  return signedRoot(worst);
}

bool VertexLink::allPositiveFrom(int apex) const
{
  const Vector3& q = mesh_.point(ends_[apex]);
  return std::all_of(faces_.begin(), faces_.end(),
    [&](const Face& face)
    {
      const auto& c = face.corner;
      return face.has(apex) ||
        isPositive(mesh_.point(ends_[c[0]]), mesh_.point(ends_[c[1]]), mesh_.point(ends_[c[2]]), q);
    });
}

std::size_t VertexLink::countPoor(int apex, double floor) const
{
  const Vector3 place = places_[apex];
  const double squareOfApex = dot(place, place);
  const double floorSquare = floor * std::fabs(floor);
  std::size_t count = 0;
  for (std::size_t i = 0; i < ball_.size(); ++i)
  {
    count += !faces_[i].has(apex) && !(faces_[i].view.signedSquare(place, squareOfApex) > floorSquare);
  }
  return count;
}

void VertexLink::undoGrowth()
{
  inGrown_.clear();
  grown_.clear();
  starred_.clear();
  faces_.resize(ball_.size()); // one for each tetrahedron at v
  viewed_ = faces_.size();
}

void VertexLink::growBeyond(HalfFace face)
{
  const Index t = tetOf(face);
  inGrown_.set(t);
  grown_.push_back(t);
  for (int f = 0; f < 4; ++f)
  {
    if (!isInside(mesh_.tet(t).neighbour[f]))
    {
      addFace(mesh_.tet(t), f);
    }
  }
  placeNewEnds();
}

double VertexLink::grow(int apex, double floor, std::size_t budget, const BoundaryRules& rules)
{
  undoGrowth();
  const Vector3 place = places_[apex];
  const double squareOfApex = dot(place, place);
  const double floorSquare = floor * std::fabs(floor);
  double worst = std::numeric_limits<double>::infinity();
  // They become more as the loop goes.
  for (std::size_t i = 0; i < faces_.size(); ++i) // NOLINT(modernize-loop-convert)
  {
    const HalfFace beyond = faces_[i].beyond;
    if (isInside(beyond) || faces_[i].has(apex))
    {
      continue;
    }
    const double square = faces_[i].view.signedSquare(place, squareOfApex);
    if (square > floorSquare)
    {
      worst = std::min(worst, square);
    }
    else if (isBoundary(beyond) && rules.mayStar(mesh_.patchOf(beyond), ends_[apex]))
    {
      starred_.push_back(boundaryFaceOf(beyond));
    }
    else if (isBoundary(beyond) || grown_.size() >= budget)
    {
      return floor;
    }
    else
    {
      growBeyond(beyond);
    }
  }
  return signedRoot(worst);
}
} // namespace ransmesh

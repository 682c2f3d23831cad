#include "Improvement/VertexLink.h"

#include "Geometry/Predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

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
  squares_.clear();
  faces_.clear();
  views_.clear();
  grown_.clear();
  starred_.clear();
  collectBall(v);
  endsAtV_ = ends_.size();
  asked_.resize(faces_.size());
  std::iota(asked_.begin(), asked_.end(), std::size_t{ 0 });
}

void VertexLink::collectBall(Index v)
{
  ball_.clear();
  ball_.makeRoom(1);
  ball_.add(mesh_.tetAt(v));
  inBall_.set(ball_[0]);
  for (std::size_t i = 0; i < ball_.size(); ++i)
  {
    const Tetrahedron& tet = mesh_.tet(ball_[i]);
    const int cornerOfV = tet.cornerOf(v);
    ball_.makeRoom(4);
    for (int f = 0; f < 4; ++f)
    {
      const HalfFace other = tet.neighbour[f];
      if (f != cornerOfV && !isBoundary(other) && inBall_.set(tetOf(other)))
      {
        mesh_.fetchAhead(tetOf(other));
        ball_.add(tetOf(other));
      }
    }
    addFace(tet, cornerOfV);
  }
  placeNewEnds();
}

// After faces have been added: all at once, so that none has to be waited for alone.
void VertexLink::placeNewEnds()
{
  places_.makeRoom(ends_.size());
  squares_.makeRoom(ends_.size());
  views_.makeRoom(faces_.size());
  for (std::size_t i = places_.size(); i < ends_.size(); ++i)
  {
    const Vector3 place = mesh_.point(ends_[i]) - centre_;
    places_.add(place);
    squares_.add(dot(place, place));
  }
  for (std::size_t i = views_.size(); i < faces_.size(); ++i)
  {
    const auto [a, b, c] = faces_[i].corner;
    views_.add({ places_[a], places_[b], places_[c], squares_[a] + squares_[b] + squares_[c] });
  }
}

// The face opposite to a corner.
inline void VertexLink::addFace(const Tetrahedron& tet, int corner)
{
  ends_.makeRoom(3);
  faces_.makeRoom(1);
  const auto& f = FaceCorners[corner];
  const int a = localNumber(tet.vertex[f[0]]);
  const int b = localNumber(tet.vertex[f[1]]);
  const int c = localNumber(tet.vertex[f[2]]);
  faces_.add({ { a, b, c }, tet.neighbour[corner] });
}

double VertexLink::worst() const
{
  double worst = std::numeric_limits<double>::infinity();
  for (const FaceView& view : views_.view())
  {
    worst = std::min(worst, view.signedSquare({}, 0));
  }
  return signedRoot(worst);
}

double VertexLink::worstFrom(int apex, double floor)
{
  undoGrowth();
  const Vector3 place = places_[apex];
  const double floorSquare = floor * std::fabs(floor);
  double worst = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < asked_.size(); ++i)
  {
    const std::size_t face = asked_[i];
    if (faces_[face].has(apex))
    {
      continue;
    }
    worst = std::min(worst, views_[face].signedSquare(place, squares_[apex]));
    if (!(worst > floorSquare))
    {
      std::swap(asked_[i], asked_[i / 2]); // faces that refuse often are asked first
      return floor;
    }
  }
  return signedRoot(worst);
}

bool VertexLink::allPositiveFrom(int apex) const
{
  double radius = 0; // of the ball, in one coordinate
  for (const Vector3& place : places())
  {
    radius = std::max({ radius, std::fabs(place.x), std::fabs(place.y), std::fabs(place.z) });
  }
  // Places and volumes are rounded some tens of times, each by at most 2^-53 of the ball's extent.
  constexpr double certain = 1e-12;
  const double safe = certain * radius * radius * radius;
  const Vector3& q = mesh_.point(ends_[apex]);
  for (std::size_t i = 0; i < ball_.size(); ++i)
  {
    const auto& c = faces_[i].corner;
    if (!faces_[i].has(apex) && !(views_[i].sixVolume(places_[apex]) > safe) &&
      !isPositive(mesh_.point(ends_[c[0]]), mesh_.point(ends_[c[1]]), mesh_.point(ends_[c[2]]), q))
    {
      return false;
    }
  }
  return true;
}

std::size_t VertexLink::countPoor(int apex, double floor, std::size_t most) const
{
  const Vector3 place = places_[apex];
  const double squareOfApex = squares_[apex];
  const double floorSquare = floor * std::fabs(floor);
  std::size_t count = 0;
  for (std::size_t i = 0; i < ball_.size() && count < most; ++i)
  {
    count += !faces_[i].has(apex) && !views_[i].isAbove(floorSquare, place, squareOfApex);
  }
  return count;
}

void VertexLink::undoGrowth()
{
  inGrown_.clear();
  grown_.clear();
  starred_.clear();
  faces_.shrink(ball_.size()); // one for each tetrahedron at v
  views_.shrink(ball_.size());
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
  const double squareOfApex = squares_[apex];
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
    const double square = views_[i].signedSquare(place, squareOfApex);
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

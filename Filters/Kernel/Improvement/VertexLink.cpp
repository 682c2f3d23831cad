#include "Improvement/VertexLink.h"

#include "Geometry/Predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ransmesh
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

// The corner that follows another one in the face opposite to a corner: Following[opposite][corner].
constexpr int Following[4][4] = { { -1, 3, 1, 2 }, { 2, -1, 3, 0 }, { 3, 0, -1, 1 }, { 1, 2, 0, -1 } };

double signedSquareOf(double quality)
{
  return quality * std::fabs(quality);
}
} // namespace

void VertexLink::turnTo(Index v)
{
  numbers_.clear();
  inBall_.clear();
  inGrown_.clear();
  centre_ = mesh_.point(v);
  ball_.clear();
  entries_.clear();
  ends_.clear();
  places_.clear();
  squares_.clear();
  faces_.clear();
  grownViews_.clear();
  grown_.clear();
  starred_.clear();
  enterBall(v);
  collectBall(v);
  placeEnds();
  endsAtV_ = ends_.size();
  pairFaces();
}

// The first tetrahedron: its vertices get numbers.
void VertexLink::enterBall(Index v)
{
  const Index first = mesh_.tetAt(v);
  const Tetrahedron& tet = mesh_.tet(first);
  const int cornerOfV = tet.cornerOf(v);
  ball_.makeRoom(5);
  entries_.makeRoom(5);
  ends_.makeRoom(4);
  faces_.makeRoom(1);
  ball_.add(first);
  entries_.add({});
  inBall_.set(first);
  int number[4] = {};
  for (const int corner : FaceCorners[cornerOfV])
  {
    number[corner] = localNumber(tet.vertex[corner]);
  }
  for (int f = 0; f < 4; ++f)
  {
    if (f != cornerOfV)
    {
      const int next = Following[cornerOfV][f];
      leaveThrough(tet.neighbour[f], number[Following[cornerOfV][next]], number[next]);
    }
  }
  const auto& f = FaceCorners[cornerOfV];
  faces_.add({ { number[f[0]], number[f[1]], number[f[2]] }, tet.neighbour[cornerOfV] });
}

// The others: each has one vertex that the one before has not, so that only that is looked for.
void VertexLink::collectBall(Index v)
{
  for (std::size_t i = 1; i < ball_.size(); ++i)
  {
    ball_.makeRoom(3);
    entries_.makeRoom(3);
    ends_.makeRoom(1);
    faces_.makeRoom(1);
    const Tetrahedron& tet = mesh_.tet(ball_[i]);
    const Entry entry = entries_[i];
    const int cornerOfV = tet.cornerOfOwn(v);
    const auto& following = Following[cornerOfV];
    const int next = following[entry.corner];
    const int last = following[next];
    int number[4];
    number[entry.corner] = localNumber(tet.vertex[entry.corner]);
    number[next] = entry.next;
    number[last] = entry.last;
    const auto& f = FaceCorners[cornerOfV];
    faces_.add({ { number[f[0]], number[f[1]], number[f[2]] }, tet.neighbour[cornerOfV] });
    for (const int out : { std::min(next, last), std::max(next, last) })
    {
      leaveThrough(tet.neighbour[out], number[following[following[out]]], number[following[out]]);
    }
  }
}

// There must be room.
inline void VertexLink::leaveThrough(HalfFace face, int next, int last)
{
  if (!isBoundary(face))
  {
    const bool fresh = inBall_.set(tetOf(face));
    mesh_.fetchAhead(tetOf(face));
    ball_.addIf(fresh, tetOf(face));
    entries_.addIf(fresh, { faceOf(face), next, last });
  }
}

// After ends have been added: all at once, so that none has to be waited for alone.
void VertexLink::placeEnds()
{
  places_.makeRoom(ends_.size());
  squares_.makeRoom(ends_.size());
  for (std::size_t i = places_.size(); i < ends_.size(); ++i)
  {
    const Vector3 place = mesh_.point(ends_[i]) - centre_;
    places_.add(place);
    squares_.add(dot(place, place));
  }
}

void VertexLink::pairFaces()
{
  const std::size_t count = faces_.size();
  pairs_.clear();
  asked_.clear();
  pairs_.makeRoom((count + 1) / 2);
  asked_.makeRoom((count + 1) / 2);
  for (std::size_t i = 0; i < count; i += 2)
  {
    const auto& other = faces_[std::min(i + 1, count - 1)].corner;
    asked_.add(static_cast<std::uint32_t>(pairs_.size()));
    pairs_.add({ faces_[i].corner, other, &places_[0], &squares_[0] });
  }
}

double VertexLink::worst() const
{
  constexpr int noEnd = -1;
  return worstFrom(Viewpoint(noEnd, {}, 0));
}

double VertexLink::worstFrom(int apex, double floor)
{
  undoGrowth();
  const Viewpoint from = viewFrom(apex);
  const double floorSquare = signedSquareOf(floor);
  for (std::size_t i = 0; i < asked_.size(); ++i)
  {
    if (pairs_[asked_[i]].somePoor(from, floorSquare))
    {
      std::swap(asked_[i], asked_[i / 2]); // faces that refuse often are asked first
      return floor;
    }
  }
  return worstFrom(from);
}

double VertexLink::worstFrom(const Viewpoint& from) const
{
  Two worst = both(Infinity);
  for (const FacePair& pair : pairs_.view())
  {
    worst = lesser(worst, pair.signedSquares(from));
  }
  return signedRoot(least(worst));
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
  const Viewpoint from = viewFrom(apex);
  const Vector3& q = mesh_.point(ends_[apex]);
  for (std::size_t i = 0; i < ball_.size(); ++i)
  {
    const auto& c = faces_[i].corner;
    if (pairs_[i / 2].mayBeFlat(from, safe)[i % 2] != 0 &&
      !isPositive(mesh_.point(ends_[c[0]]), mesh_.point(ends_[c[1]]), mesh_.point(ends_[c[2]]), q))
    {
      return false;
    }
  }
  return true;
}

std::size_t VertexLink::countPoor(int apex, double floor, std::size_t most) const
{
  const Viewpoint from = viewFrom(apex);
  const double floorSquare = signedSquareOf(floor);
  const std::size_t whole = ball_.size() / 2;
  std::size_t count = 0;
  for (std::size_t i = 0; i < whole && count < most; ++i)
  {
    const auto poor = pairs_[i].arePoor(from, floorSquare);
    count -= static_cast<std::size_t>(poor[0] + poor[1]); // -1 each
  }
  if (whole < pairs_.size() && count < most)
  {
    count -= static_cast<std::size_t>(pairs_[whole].arePoor(from, floorSquare)[0]);
  }
  return count;
}

void VertexLink::undoGrowth()
{
  if (!grown_.empty())
  {
    inGrown_.clear();
    grown_.clear();
    faces_.shrink(ball_.size()); // one for each tetrahedron at v
    grownViews_.clear();
  }
  starred_.clear();
}

void VertexLink::growBeyond(HalfFace face)
{
  const Index t = tetOf(face);
  inGrown_.set(t);
  grown_.push_back(t);
  const Tetrahedron& tet = mesh_.tet(t);
  for (int f = 0; f < 4; ++f)
  {
    if (!isInside(tet.neighbour[f]))
    {
      addGrownFace(tet, f);
    }
  }
}

// The face opposite to a corner.
void VertexLink::addGrownFace(const Tetrahedron& tet, int corner)
{
  ends_.makeRoom(3);
  faces_.makeRoom(1);
  grownViews_.makeRoom(1);
  const auto& f = FaceCorners[corner];
  const int a = localNumber(tet.vertex[f[0]]);
  const int b = localNumber(tet.vertex[f[1]]);
  const int c = localNumber(tet.vertex[f[2]]);
  placeEnds();
  faces_.add({ { a, b, c }, tet.neighbour[corner] });
  grownViews_.add({ places_[a], places_[b], places_[c], squares_[a] + squares_[b] + squares_[c] });
}

double VertexLink::grow(int apex, double floor, std::size_t budget, const BoundaryRules& rules)
{
  undoGrowth();
  const Viewpoint from = viewFrom(apex);
  Growth growth{ apex, signedSquareOf(floor), budget, Infinity };
  for (std::size_t i = 0; i < ball_.size(); i += 2)
  {
    const Two squares = pairs_[i / 2].signedSquares(from);
    if (!growAt(i, squares[0], growth, rules) ||
      (i + 1 < ball_.size() && !growAt(i + 1, squares[1], growth, rules)))
    {
      return floor;
    }
  }
  const Vector3 place = places_[apex];
  const double squareOfApex = squares_[apex];
  for (std::size_t i = ball_.size(); i < faces_.size(); ++i) // they become more as the loop goes
  {
    const double square =
      faces_[i].has(apex) ? Infinity : grownViews_[i - ball_.size()].signedSquare(place, squareOfApex);
    if (!growAt(i, square, growth, rules))
    {
      return floor;
    }
  }
  return signedRoot(growth.worst);
}

// At a face that sees the apex so (infinity: has it). False if the cavity cannot be starred.
bool VertexLink::growAt(std::size_t face, double square, Growth& growth, const BoundaryRules& rules)
{
  const HalfFace beyond = faces_[face].beyond;
  if (square == Infinity || (!grown_.empty() && isInside(beyond)))
  {
    return true;
  }
  if (square > growth.floorSquare)
  {
    growth.worst = std::min(growth.worst, square);
    return true;
  }
  if (isBoundary(beyond))
  {
    const bool mayStar = rules.mayStar(mesh_.patchOf(beyond), ends_[growth.apex]);
    if (mayStar)
    {
      starred_.push_back(boundaryFaceOf(beyond));
    }
    return mayStar;
  }
  if (grown_.size() >= growth.budget)
  {
    return false;
  }
  growBeyond(beyond);
  return true;
}
} // namespace ransmesh

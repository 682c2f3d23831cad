#include "Improvement/LocalImprovement.h"

#include "Geometry/Predicates.h"
#include "Geometry/TetrahedronMeasures.h"

#include <algorithm>
#include <limits>

namespace ransmesh
{
namespace
{
constexpr double worthwhile = 1.05; // by this factor the worst shape must rise
} // namespace

double LocalImprovement::worstOf(std::span<const Index> tets)
{
  double worst = std::numeric_limits<double>::infinity();
  for (const Index t : tets)
  {
    worst = std::min(worst, shapeOf(t, worst));
  }
  return worst;
}

// The same; puts the one of that shape first.
double LocalImprovement::worstFirst(std::vector<Index>& tets)
{
  double worst = std::numeric_limits<double>::infinity();
  for (Index& t : tets)
  {
    if (const double shape = shapeOf(t, worst); shape < worst)
    {
      worst = shape;
      std::swap(t, tets.front());
    }
  }
  return worst;
}

double LocalImprovement::shapeOf(Index tet, double ceiling)
{
  return shapes_.of(tet, ceiling, [&] { return shapeOf(mesh_.tet(tet).vertex, { 0, ceiling }); });
}

void LocalImprovement::forgetShapes(std::span<const Index> tets)
{
  for (const Index t : tets)
  {
    shapes_.forget(t);
  }
}

namespace
{
// The edges (bit i for edge i) of the tetrahedron's own boundary faces.
unsigned edgesOnBoundary(const Tetrahedron& tet)
{
  unsigned edges = 0;
  for (int edge = 0; edge < 6; ++edge)
  {
    for (int face = 0; face < 4; ++face)
    {
      const bool has = EdgeCorners[edge][0] != face && EdgeCorners[edge][1] != face;
      edges |= has && isBoundary(tet.neighbour[face]) ? 1U << edge : 0;
    }
  }
  return edges;
}
} // namespace

bool LocalImprovement::swap(Index tet, const SwapMemory& memory)
{
  constexpr unsigned allCorners = 0b1111;
  const auto mayTry = [&memory](unsigned needed) { return (memory.corners & needed) == needed; };
  const unsigned onBoundary = edgesOnBoundary(mesh_.tet(tet));
  for (int edge = 0; edge < 6; ++edge)
  {
    if ((onBoundary >> edge & 1U) == 0 && mayTry(1U << EdgeCorners[edge][0] | 1U << EdgeCorners[edge][1]) &&
      swapEdge(tet, edge, memory))
    {
      return true;
    }
  }
  for (int face = 0; face < 4; ++face)
  {
    if (mayTry(allCorners & ~(1U << face)) && swapFace(tet, face, memory))
    {
      return true;
    }
  }
  return false;
}

// Collects the tetrahedra around the edge (a, b) and the vertices of their ring, counterclockwise as seen
// from b; false if the ring is not closed inside the mesh, or too large.
bool LocalImprovement::walkAround(Index tet, Index a, Index b)
{
  cavity_.tets.clear();
  ring_.clear();
  const Tetrahedron& first = mesh_.tet(tet);
  const int cornerOfA = first.cornerOf(a);
  const int cornerOfB = first.cornerOf(b);
  // Of the face opposite to a, turned inward, the vertex before b.
  int last = 0;
  for (int j = 0; j < 3; ++j)
  {
    last = FaceCorners[cornerOfA][j] == cornerOfB ? FaceCorners[cornerOfA][(j + 2) % 3] : last;
  }
  Index behind = first.vertex[last];
  for (Index t = tet;;)
  {
    const Tetrahedron& here = mesh_.tet(t);
    cavity_.tets.push_back(t);
    ring_.push_back(behind);
    const HalfFace beyond = here.neighbour[here.cornerOf(behind)];
    if (isBoundary(beyond) || cavity_.tets.size() > largestRing_)
    {
      return false;
    }
    for (const Index w : here.vertex)
    {
      if (w != a && w != b && w != ring_.back())
      {
        behind = w;
      }
    }
    t = tetOf(beyond);
    if (t == tet)
    {
      return true;
    }
  }
}

// The worst shape if the edge (a, b) went and its ring were starred from one of its vertices; gives up,
// with floor or less, as soon as one is not better than floor.
double LocalImprovement::worstWithout(Index a, Index b, std::size_t apex, double floor) const
{
  const std::size_t count = ring_.size();
  double worst = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i + 1 < count && worst > floor; ++i)
  {
    const Index from = ring_[(apex + i) % count];
    const Index to = ring_[(apex + i + 1) % count];
    worst = std::min(worst, shapeOf({ ring_[apex], from, to, b }, { floor, worst }));
    if (worst > floor)
    {
      worst = std::min(worst, shapeOf({ ring_[apex], to, from, a }, { floor, worst }));
    }
  }
  return worst;
}

bool LocalImprovement::swapEdge(Index tet, int edge, const SwapMemory& memory)
{
  const Index a = mesh_.tet(tet).vertex[EdgeCorners[edge][0]];
  const Index b = mesh_.tet(tet).vertex[EdgeCorners[edge][1]];
  if (!walkAround(tet, a, b) ||
    !memory.anyHasChanged(cavity_.tets, std::max(memory.triedAt, edges_.triedAt(a, b))))
  {
    return false;
  }
  double floor = worthwhile * worstOf(cavity_.tets);
  Index best = None;
  for (std::size_t i = 0; i < ring_.size(); ++i)
  {
    const double worst = worstWithout(a, b, i, floor);
    if (worst > floor)
    {
      best = ring_[i];
      floor = worst;
    }
  }
  if (best != None && star(best))
  {
    return true;
  }
  edges_.note(a, b, memory.now);
  return false;
}

// The worst shape if the face between d, on its inner side, and e gave way to an edge between these.
double LocalImprovement::worstWith(Index d, Index e, const std::array<Index, 3>& face, double floor) const
{
  double worst = std::numeric_limits<double>::infinity();
  for (int j = 0; j < 3 && worst > floor; ++j)
  {
    worst = std::min(worst, shapeOf({ e, d, face[j], face[(j + 1) % 3] }, { floor, worst }));
  }
  return worst;
}

bool LocalImprovement::swapFace(Index tet, int face, const SwapMemory& memory)
{
  const Tetrahedron& here = mesh_.tet(tet);
  const HalfFace beyond = here.neighbour[face];
  if (isBoundary(beyond))
  {
    return false;
  }
  const Index d = here.vertex[face];
  const Index e = mesh_.tet(tetOf(beyond)).vertex[faceOf(beyond)];
  cavity_.tets = { tet, tetOf(beyond) };
  if (!memory.anyHasChanged(cavity_.tets, memory.triedAt))
  {
    return false;
  }
  const double floor = worthwhile * worstOf(cavity_.tets);
  return worstWith(d, e, here.face(face), floor) > floor && star(d);
}

// Stars the cavity from the apex, if that is possible.
bool LocalImprovement::star(Index apex)
{
  if (star_.check(cavity_, apex) != StarVerdict::Possible || !star_.lostVertices().empty())
  {
    return false;
  }
  made_ = &star_.apply();
  forgetShapes(*made_);
  return true;
}

Vector3 LocalImprovement::meanNeighbour(Index v) const
{
  // Each neighbour counts as often as it has tetrahedra here: nearly the same, and quick.
  Vector3 sum;
  for (const Index t : tets_)
  {
    for (const Index w : mesh_.tet(t).vertex)
    {
      if (w != v)
      {
        sum += mesh_.point(w);
      }
    }
  }
  return (1.0 / (3.0 * static_cast<double>(tets_.size()))) * sum;
}

bool LocalImprovement::move(Index v, double keep)
{
  if (rules_.classification.kind[v] != VertexKind::Volume)
  {
    return false;
  }
  traversal_.ball(v, tets_);
  const Vector3 place = meanNeighbour(v);
  return moveOnto(v, place, keep * worstFirst(tets_));
}

bool LocalImprovement::moveTowards(Index v, const Vector3& place, double floor)
{
  if (rules_.classification.kind[v] != VertexKind::Volume)
  {
    return false;
  }
  traversal_.ball(v, tets_);
  return moveOnto(v, place, std::min(floor, 0.999 * worstFirst(tets_)));
}

// Moves v, whose ball is in tets_, as far towards the place as leaves all qualities above wanted.
bool LocalImprovement::moveOnto(Index v, const Vector3& place, double wanted)
{
  const Vector3 from = mesh_.point(v);
  const Vector3 step = place - from;
  constexpr double shortest = 0.1;
  for (double fraction = 0.9; fraction > shortest; fraction *= 0.6)
  {
    mesh_.movePoint(v, from + fraction * step);
    if (allAbove(wanted) && allPositive())
    {
      forgetShapes(tets_);
      return true;
    }
  }
  mesh_.movePoint(v, from);
  return false;
}

// The shape of a flat one may be positive by rounding.
bool LocalImprovement::allPositive() const
{
  return std::all_of(tets_.begin(), tets_.end(),
    [this](Index t)
    {
      const auto& v = mesh_.tet(t).vertex;
      return isPositive(mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]), mesh_.point(v[3]));
    });
}

// Are the shapes of all tetrahedra in tets_ above wanted? One that is not is asked first the next time.
bool LocalImprovement::allAbove(double wanted)
{
  const auto refusing = std::find_if(tets_.begin(), tets_.end(),
    [&](Index t) {
      return !(shapeOf(mesh_.tet(t).vertex, { wanted, wanted }) > wanted);
    });
  if (refusing == tets_.end())
  {
    return true;
  }
  std::swap(*refusing, tets_.front());
  return false;
}
} // namespace ransmesh

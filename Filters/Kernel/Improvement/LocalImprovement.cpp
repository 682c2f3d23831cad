#include "Improvement/LocalImprovement.h"

#include "Geometry/TetrahedronMeasures.h"

#include <algorithm>
#include <limits>

namespace ransmesh
{
double LocalImprovement::worstOf(std::span<const Index> tets) const
{
  double worst = std::numeric_limits<double>::infinity();
  for (const Index t : tets)
  {
    worst = std::min(worst, shapeOf(t));
  }
  return worst;
}

double LocalImprovement::shapeOf(Index tet) const
{
  const auto& v = mesh_.tet(tet).vertex;
  return measure_(mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]), mesh_.point(v[3]));
}

bool LocalImprovement::swap(Index tet)
{
  for (int edge = 0; edge < 6; ++edge)
  {
    if (swapEdge(tet, edge))
    {
      return true;
    }
  }
  for (int face = 0; face < 4; ++face)
  {
    if (swapFace(tet, face))
    {
      return true;
    }
  }
  return false;
}

// Whether the tetrahedra around the edge (a, b), in tets_, close a ring inside the mesh.
bool LocalImprovement::ringIsClosed(Index a, Index b) const
{
  return std::all_of(tets_.begin(), tets_.end(),
    [&](Index t)
    {
      const Tetrahedron& tet = mesh_.tet(t);
      for (int f = 0; f < 4; ++f)
      {
        if (tet.vertex[f] != a && tet.vertex[f] != b && isBoundary(tet.neighbour[f]))
        {
          return false;
        }
      }
      return true;
    });
}

bool LocalImprovement::swapEdge(Index tet, int edge)
{
  const Index a = mesh_.tet(tet).vertex[EdgeCorners[edge][0]];
  const Index b = mesh_.tet(tet).vertex[EdgeCorners[edge][1]];
  traversal_.ring(tet, a, b, tets_);
  constexpr std::size_t largestRing = 9;
  if (tets_.size() > largestRing || !ringIsClosed(a, b))
  {
    return false;
  }
  apexes_.clear();
  for (const Index t : tets_)
  {
    for (const Index v : mesh_.tet(t).vertex)
    {
      if (v != a && v != b && std::find(apexes_.begin(), apexes_.end(), v) == apexes_.end())
      {
        apexes_.push_back(v);
      }
    }
  }
  return starBest(tets_, apexes_);
}

bool LocalImprovement::swapFace(Index tet, int face)
{
  const HalfFace beyond = mesh_.tet(tet).neighbour[face];
  if (isBoundary(beyond))
  {
    return false;
  }
  tets_ = { tet, tetOf(beyond) };
  apexes_ = { mesh_.tet(tet).vertex[face] };
  return starBest(tets_, apexes_);
}

// Stars the tetrahedra from the best of the apexes, if that raises the worst quality.
bool LocalImprovement::starBest(std::span<const Index> tets, std::span<const Index> apexes)
{
  constexpr double worthwhile = 1.05;
  cavity_.begin(tets, {});
  double floor = worthwhile * worstOf(tets);
  Index best = None;
  for (const Index apex : apexes)
  {
    const double worst = cavity_.worstFrom(apex, floor);
    if (worst > floor && worst < std::numeric_limits<double>::infinity())
    {
      best = apex;
      floor = worst;
    }
  }
  if (best == None || star_.check(cavity_.cavity(), best) != StarVerdict::Possible ||
    !star_.lostVertices().empty())
  {
    return false;
  }
  made_ = &star_.apply();
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
  return moveOnto(v, meanNeighbour(v), keep * worstOf(tets_));
}

bool LocalImprovement::moveTowards(Index v, const Vector3& place, double floor)
{
  if (rules_.classification.kind[v] != VertexKind::Volume)
  {
    return false;
  }
  traversal_.ball(v, tets_);
  return moveOnto(v, place, std::min(floor, 0.999 * worstOf(tets_)));
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
    if (worstOf(tets_) > wanted)
    {
      return true;
    }
  }
  mesh_.movePoint(v, from);
  return false;
}
} // namespace ransmesh

#include "Remeshing/RemeshGuard.h"

#include "Geometry/Distance.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
constexpr double LowAngle = 5;   // degrees; collapses make no smaller one
constexpr double GoodAngle = 30; // degrees; moves need not make it greater

bool has(const Corners& t, Index v)
{
  return t[0] == v || t[1] == v || t[2] == v;
}

Corners replaced(Corners t, Index gone, Index kept)
{
  std::replace(t.begin(), t.end(), gone, kept);
  return t;
}
} // namespace

RemeshGuard::RemeshGuard(EditableSurface& surface, const SurfaceReference& reference)
  : surface_(surface)
  , reference_(reference)
{
}

double RemeshGuard::leastAngleAround(Index v) const
{
  double least = 180;
  for (const Index t : surface_.trianglesAt(v))
  {
    least = std::min(least, smallestAngle(surface_.surface(), surface_.triangle(t)));
  }
  return least;
}

// The cosine between a triangle's normal and the given surface's at its middle.
double RemeshGuard::following(const Corners& corners, int patch) const
{
  const auto& p = surface_.surface().points;
  const Vector3 middle = (1.0 / 3) * (p[corners[0]] + p[corners[1]] + p[corners[2]]);
  const Vector3 normal = normalized(areaVector(surface_.surface(), corners));
  return dot(normal, reference_.closestOnPatch(middle, patch).normal);
}

bool RemeshGuard::follows(const Corners& made, int patch, double least) const
{
  return following(made, patch) >= least;
}

// The distance of an edge's middle from a patch.
double RemeshGuard::offPatch(const Vector3& a, const Vector3& b, int patch) const
{
  const Vector3 middle = 0.5 * (a + b);
  return distance(middle, reference_.closestOnPatch(middle, patch).place);
}

double RemeshGuard::offLine(const Vector3& a, const Vector3& b, Index line) const
{
  double most = 0;
  for (const double part : { 0.25, 0.5, 0.75 })
  {
    const Vector3 p = a + part * (b - a);
    most = std::max(most, distance(p, reference_.closestOnLine(p, line).place));
  }
  return most;
}

bool RemeshGuard::lineAllows(Index gone, Index kept, double tolerance) const
{
  const Index line = surface_.lineOf(gone, kept);
  for (const Index end : line == None ? std::vector<Index>() : surface_.neighboursOnLines(gone))
  {
    const Vector3& a = surface_.point(kept);
    const Vector3& b = surface_.point(end);
    if (end != kept &&
      (offLine(a, b, line) > tolerance || distanceToTriangle(surface_.point(gone), a, b, b) > tolerance))
    {
      return false;
    }
  }
  return true;
}

bool RemeshGuard::allowsCollapse(Index gone, Index kept, double tolerance) const
{
  const double cosine = cosineOfDegrees(TurnOfTriangle);
  const double leastAngle = std::min(LowAngle, leastAngleAround(gone));
  double nearest = INFINITY; // of the point that goes, to what comes
  for (const Index t : surface_.trianglesAt(gone))
  {
    const Corners& old = surface_.triangle(t);
    if (has(old, kept))
    {
      continue;
    }
    const Corners made = replaced(old, gone, kept);
    if (smallestAngle(surface_.surface(), made) < leastAngle)
    {
      return false;
    }
    const int patch = surface_.patch(t);
    const double now = following(made, patch);
    if (now < cosine && now < following(old, patch))
    {
      return false;
    }
    nearest = std::min(nearest,
      distanceToTriangle(
        surface_.point(gone), surface_.point(made[0]), surface_.point(made[1]), surface_.point(made[2])));
  }
  if (nearest > tolerance || !lineAllows(gone, kept, tolerance))
  {
    return false;
  }
  for (const Index w : surface_.neighbours(gone))
  {
    if (w != kept && surface_.lineOf(gone, w) == None)
    {
      const int patch = surface_.patch(surface_.trianglesAt(gone, w)[0]);
      if (offPatch(surface_.point(kept), surface_.point(w), patch) > tolerance)
      {
        return false;
      }
    }
  }
  return true;
}

bool RemeshGuard::allowsSwap(Index a, Index b, const std::array<Corners, 2>& made, double tolerance) const
{
  const std::vector<Index> at = surface_.trianglesAt(a, b);
  const int patch = surface_.patch(at[0]);
  const double least = std::min({ cosineOfDegrees(TurnOfTriangle), following(surface_.triangle(at[0]), patch),
    following(surface_.triangle(at[1]), patch) });
  const Index c = surface_.cornerOpposite(at[0], a, b);
  const Index d = surface_.cornerOpposite(at[1], a, b);
  const double now = offPatch(surface_.point(a), surface_.point(b), patch);
  return offPatch(surface_.point(c), surface_.point(d), patch) <= std::max(tolerance, now) &&
    follows(made[0], patch, least) && follows(made[1], patch, least);
}

bool RemeshGuard::collapseBetters(Index gone, Index kept) const
{
  double least = 180;
  for (const Index t : surface_.trianglesAt(gone))
  {
    if (!has(surface_.triangle(t), kept))
    {
      least = std::min(least, smallestAngle(surface_.surface(), replaced(surface_.triangle(t), gone, kept)));
    }
  }
  return least > leastAngleAround(gone);
}

// How far the edges at a point lie from the given surface and lines.
double RemeshGuard::farthestOfEdges(Index v) const
{
  double most = 0;
  for (const Index w : surface_.neighbours(v))
  {
    if (surface_.lineOf(v, w) == None)
    {
      const int patch = surface_.patch(surface_.trianglesAt(v, w)[0]);
      most = std::max(most, offPatch(surface_.point(v), surface_.point(w), patch));
    }
  }
  for (const Index w :
    surface_.freedom(v) == PointFreedom::Line ? surface_.neighboursOnLines(v) : std::vector<Index>())
  {
    most = std::max(most, offLine(surface_.point(v), surface_.point(w), surface_.lineOf(v, w)));
  }
  return most;
}

void RemeshGuard::moveIfBetter(Index v, const Vector3& place, double tolerance)
{
  const Vector3 before = surface_.point(v);
  const double angle = leastAngleAround(v);
  std::vector<double> turns;
  for (const Index t : surface_.trianglesAt(v))
  {
    turns.push_back(following(surface_.triangle(t), surface_.patch(t)));
  }
  surface_.move(v, place);
  bool isFine = leastAngleAround(v) >= std::min(angle, GoodAngle);
  for (std::size_t i = 0; isFine && i < turns.size(); ++i)
  {
    const Index t = surface_.trianglesAt(v)[i];
    isFine =
      follows(surface_.triangle(t), surface_.patch(t), std::min(turns[i], cosineOfDegrees(TurnOfTriangle)));
  }
  const double off = isFine ? farthestOfEdges(v) : 0;
  if (!isFine || off > tolerance)
  {
    surface_.move(v, before);
    if (isFine && off <= farthestOfEdges(v)) // it was worse
    {
      surface_.move(v, place);
    }
  }
}
} // namespace ransmesh

#include "Layers/RayWalk.h"

#include <algorithm>
#include <limits>

namespace ransmesh
{
double RayWalk::freeDistance(Index v, const Vector3& d, double reach)
{
  const Vector3 from = mesh_.point(v);
  patchHit_ = 0;
  HalfFace exit = firstExit(v, d);
  for (int steps = 0; steps < 10000 && exit != None; ++steps)
  {
    const double s = distanceTo(exit, from, d);
    if (s >= reach)
    {
      return reach;
    }
    const HalfFace beyond = mesh_.tet(tetOf(exit)).neighbour[faceOf(exit)];
    if (isBoundary(beyond))
    {
      patchHit_ = mesh_.patchOf(beyond);
      return s;
    }
    exit = exitFrom(beyond, from, d);
  }
  return reach;
}

// Does the ray pass the three edges of the face, seen from outside, on the same side?
bool RayWalk::passes(const std::array<Index, 3>& face, const Vector3& from, const Vector3& d) const
{
  const Vector3 a = mesh_.point(face[0]) - from;
  const Vector3 b = mesh_.point(face[1]) - from;
  const Vector3 c = mesh_.point(face[2]) - from;
  // The corners are turned inward: seen along a ray that leaves, they are clockwise.
  return dot(cross(b, a), d) >= 0 && dot(cross(c, b), d) >= 0 && dot(cross(a, c), d) >= 0;
}

HalfFace RayWalk::firstExit(Index v, const Vector3& d)
{
  const Index tet = traversal_.findInBall(v,
    [&](Index t)
    {
      const Tetrahedron& at = mesh_.tet(t);
      return passes(at.face(at.cornerOf(v)), mesh_.point(v), d);
    });
  return tet == None ? None : halfFace(tet, mesh_.tet(tet).cornerOf(v));
}

// The ray passes the edges of the face that it came through: which other face it leaves by, the edges to the corner
// opposite tell.
HalfFace RayWalk::exitFrom(HalfFace entry, const Vector3& from, const Vector3& d) const
{
  const Tetrahedron& tet = mesh_.tet(tetOf(entry));
  const int apex = faceOf(entry);
  const Vector3 toApex = cross(mesh_.point(tet.vertex[apex]) - from, d);
  std::array<double, 4> side{}; // of the edge from the apex to the corner
  for (int i = 0; i < 4; ++i)
  {
    side[i] = i == apex ? 0 : dot(toApex, mesh_.point(tet.vertex[i]) - from);
  }
  for (int f = 0; f < 4; ++f)
  {
    if (f == apex)
    {
      continue;
    }
    // The face's corners after and before the apex, as it is turned.
    int at = 0;
    while (FaceCorners[f][at] != apex)
    {
      ++at;
    }
    if (side[FaceCorners[f][(at + 1) % 3]] >= 0 && side[FaceCorners[f][(at + 2) % 3]] <= 0)
    {
      return halfFace(tetOf(entry), f);
    }
  }
  return None;
}

double RayWalk::distanceTo(HalfFace h, const Vector3& from, const Vector3& d) const
{
  const auto face = mesh_.tet(tetOf(h)).face(faceOf(h));
  const Vector3& a = mesh_.point(face[0]);
  const Vector3 n = cross(mesh_.point(face[1]) - a, mesh_.point(face[2]) - a);
  const double across = dot(n, d);
  return across != 0 ? std::max(0.0, dot(n, a - from) / across) : std::numeric_limits<double>::infinity();
}
} // namespace ransmesh

#include "RandomStar.h"

#include <algorithm>
#include <cmath>

namespace kernel_driver
{
using namespace ransmesh;

void RandomStar::growCavity(Cavity& cavity, std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const Index from = cavity.tets[choices_.upTo(cavity.tets.size())];
    const HalfFace beyond = mesh_.tet(from).neighbour[choices_.upTo(4)];
    if (!isBoundary(beyond))
    {
      cavity.tets.push_back(tetOf(beyond)); // doubles, too
    }
  }
}

// A corner of the cavity, a new point in it, or one on its boundary.
bool RandomStar::chooseApex(Cavity& cavity, Index& apex)
{
  const Tetrahedron tet = mesh_.tet(cavity.tets[choices_.upTo(cavity.tets.size())]);
  const std::size_t kind = choices_.upTo(3);
  if (kind == 0)
  {
    apex = tet.vertex[choices_.upTo(4)];
    for (const int patch : classification_.patchesAt(apex))
    {
      if (choices_.upTo(2) == 0)
      {
        starFacesInPlane(cavity, apex, patch);
      }
    }
    return true;
  }
  const std::size_t f = choices_.upTo(4);
  const bool onFace = kind == 1 && isBoundary(tet.neighbour[f]);
  Vector3 place;
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const double weight = onFace && i == f ? 0 : choices_.between(0.05, 1);
    place += weight * mesh_.point(tet.vertex[i]);
    sum += weight;
  }
  apex = mesh_.addVertex((1 / sum) * place);
  if (onFace)
  {
    starFacesInPlane(cavity, apex, mesh_.patchOf(tet.neighbour[f]));
  }
  return false;
}

void RandomStar::starFacesInPlane(Cavity& cavity, Index apex, int patch) const
{
  for (const Index t : cavity.tets)
  {
    for (const HalfFace beyond : mesh_.tet(t).neighbour)
    {
      if (!isBoundary(beyond) || mesh_.patchOf(beyond) != patch)
      {
        continue;
      }
      const auto v = mesh_.boundaryVertices(boundaryFaceOf(beyond));
      const Vector3& a = mesh_.point(v[0]);
      const Vector3 n = normalized(cross(mesh_.point(v[1]) - a, mesh_.point(v[2]) - a));
      if (std::fabs(dot(n, mesh_.point(apex) - a)) < 1e-12)
      {
        cavity.starredFaces.push_back(boundaryFaceOf(beyond));
      }
    }
  }
}

// Points of ridges and corners hold the domain's shape.
bool RandomStar::losesOnlyInnerPoints(const Star& star) const
{
  return std::all_of(star.lostVertices().begin(), star.lostVertices().end(),
    [this](Index v)
    {
      const VertexKind kind = classification_.kind[v];
      return kind == VertexKind::Volume || (kind == VertexKind::Surface && isPlane_);
    });
}

void RandomStar::tryAt(Index tet)
{
  Cavity cavity;
  cavity.tets.push_back(tet);
  growCavity(cavity, choices_.upTo(24));
  Index apex = None;
  const bool isOld = chooseApex(cavity, apex);
  Star star(mesh_);
  const bool isDone = star.check(cavity, apex) == StarVerdict::Possible && losesOnlyInnerPoints(star);
  if (isDone)
  {
    star.apply();
  }
  else if (!isOld)
  {
    mesh_.removeLastVertices(1);
  }
}
} // namespace kernel_driver

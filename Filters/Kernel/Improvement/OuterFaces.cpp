#include "Improvement/OuterFaces.h"

#include "Geometry/TetrahedronMeasures.h"

#include <algorithm>
#include <limits>

namespace ransmesh
{
namespace
{
bool has(const std::array<Index, 3>& face, Index v)
{
  return face[0] == v || face[1] == v || face[2] == v;
}
} // namespace

void OuterFaces::turnTo(std::span<const Index> tets, std::initializer_list<Index> vanishing)
{
  cavity_.tets.assign(tets.begin(), tets.end());
  cavity_.starredFaces.clear();
  faces_.clear();
  inCavity_.clear();
  for (const Index t : tets)
  {
    inCavity_.set(t);
  }
  for (const Index t : tets)
  {
    addFaces(t, { vanishing.begin(), vanishing.size() });
  }
}

void OuterFaces::addFaces(Index t, std::span<const Index> vanishing)
{
  const Tetrahedron& tet = mesh_.tet(t);
  for (int f = 0; f < 4; ++f)
  {
    const HalfFace beyond = tet.neighbour[f];
    const Face face = tet.face(f);
    if (!isBoundary(beyond) && inCavity_.test(tetOf(beyond)))
    {
      continue;
    }
    if (isBoundary(beyond) && !vanishing.empty() &&
      std::all_of(vanishing.begin(), vanishing.end(), [&](Index v) { return has(face, v); }))
    {
      cavity_.starredFaces.push_back(boundaryFaceOf(beyond));
    }
    else
    {
      faces_.push_back(face);
    }
  }
}

double OuterFaces::worstFrom(Index apex, double floor)
{
  const Vector3& point = mesh_.point(apex);
  double worst = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < faces_.size(); ++i)
  {
    const Face& face = faces_[i];
    if (has(face, apex))
    {
      continue;
    }
    worst = std::min(worst, quality(mesh_.point(face[0]), mesh_.point(face[1]), mesh_.point(face[2]), point));
    if (worst <= floor)
    {
      std::swap(faces_[i], faces_[i / 2]); // faces that refuse often are asked first
      return worst;
    }
  }
  return worst;
}
} // namespace ransmesh

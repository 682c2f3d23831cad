#include "Removal/WallTurning.h"

#include "Geometry/Angles.h"

#include <algorithm>
#include <array>

namespace ransmesh
{
void WallTurning::note(std::span<const Index> made)
{
  for (const Index t : made)
  {
    for (const HalfFace beyond : mesh_.tet(t).neighbour)
    {
      if (isBoundary(beyond) && !rules_.changeable[mesh_.patchOf(beyond)])
      {
        faces_.push_back(boundaryFaceOf(beyond));
      }
    }
  }
}

std::size_t WallTurning::turnAll()
{
  std::sort(faces_.begin(), faces_.end());
  faces_.erase(std::unique(faces_.begin(), faces_.end()), faces_.end());
  const std::size_t ofAngles = turnWhereAnglesAreLarge();
  return ofAngles + separateRidges();
}

std::size_t WallTurning::turnWhereAnglesAreLarge()
{
  constexpr int rounds = 3;
  std::size_t turned = 0;
  for (int round = 0; round < rounds; ++round)
  {
    for (const Index face : faces_)
    {
      turned += static_cast<std::size_t>(mesh_.boundaryFace(face).isAlive() && turnLongestEdge(face));
    }
  }
  return turned;
}

std::size_t WallTurning::separateRidges()
{
  return static_cast<std::size_t>(
    std::count_if(faces_.begin(), faces_.end(), [this](Index face) { return turnBetweenRidges(face); }));
}

bool WallTurning::turnLongestEdge(Index face)
{
  constexpr double large = 110; // degrees
  const RemovalLimits limits{ 0.05, 0, 0, 0.5, 0 };
  const auto v = mesh_.boundaryVertices(face);
  const Vector3& a = mesh_.point(v[0]);
  const Vector3& b = mesh_.point(v[1]);
  const Vector3& c = mesh_.point(v[2]);
  const std::array<double, 3> opposite = { distance(b, c), distance(c, a), distance(a, b) };
  const auto j = std::max_element(opposite.begin(), opposite.end()) - opposite.begin();
  return largestAngle(a, b, c) > large && turn(v[(j + 1) % 3], v[(j + 2) % 3], limits);
}

bool WallTurning::turnBetweenRidges(Index face)
{
  const RemovalLimits limits{ 0.03, 0, 0, 0.5, 140 };
  const auto onRidge = [this](Index v) { return rules_.classification.kind[v] >= VertexKind::Ridge; };
  for (int j = 0; j < 3 && mesh_.boundaryFace(face).isAlive(); ++j)
  {
    const auto v = mesh_.boundaryVertices(face);
    const Index from = v[j];
    const Index to = v[(j + 1) % 3];
    if (onRidge(from) && onRidge(to) && !rules_.classification.ridges.has(from, to) && turn(from, to, limits))
    {
      return true;
    }
  }
  return false;
}

bool WallTurning::turn(Index from, Index to, const RemovalLimits& limits)
{
  const bool turned = valence_.swapOnWall(from, to, limits, {});
  if (turned)
  {
    mending_.note(valence_.made(), PoorQualityAtLast);
  }
  return turned;
}
} // namespace ransmesh

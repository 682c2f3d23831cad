#include "Removal/RefillRemover.h"

#include "Improvement/LocalImprovement.h"
#include "Mesh/LocalNumbers.h"
#include "Mesh/Refill.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace ransmesh
{
namespace
{
// A point is needed if what lies within so many rings of tetrahedra around its ball cannot be filled without it.
constexpr std::size_t RingsLookedThrough = 2;
} // namespace

RefillRemover::Verdict RefillRemover::remove(Index v, double least)
{
  collectPlaces(v);
  if (places_.empty())
  {
    return Verdict::GivenUp;
  }
  double worst = 1;
  for (const Index t : places_.front().tets)
  {
    worst = std::min(worst, qualityOf(mesh_, t));
  }
  bool isNeeded = false;
  for (const double floor : { std::max(worst, least), least })
  {
    for (std::size_t rings = 0; rings < places_.size(); ++rings)
    {
      const CavityFilling::Verdict verdict = tryAt(places_[rings], floor);
      if (verdict == CavityFilling::Verdict::Filled)
      {
        apply(places_[rings]);
        return Verdict::Removed;
      }
      isNeeded = floor == least && rings >= RingsLookedThrough &&
        (isNeeded || verdict == CavityFilling::Verdict::Impossible);
    }
  }
  return isNeeded ? Verdict::Needed : Verdict::GivenUp;
}

void RefillRemover::collectPlaces(Index v)
{
  constexpr std::size_t mostRings = 3;
  places_.clear();
  std::vector<Index> tets;
  traversal_.ball(v, tets);
  while (places_.size() <= mostRings)
  {
    Place place;
    place.tets = tets;
    if (!describe(place, v))
    {
      break;
    }
    places_.push_back(std::move(place));
    addRing(tets);
  }
}

// False if there are too many points.
bool RefillRemover::describe(Place& place, Index without) const
{
  LocalNumbers numbers;
  const auto numberOf = [&](Index v)
  {
    const int number = numbers.add(v);
    if (number == static_cast<int>(place.vertices.size()))
    {
      place.vertices.push_back(v);
    }
    return number;
  };
  std::vector<std::array<int, 3>> faces;
  for (const RimFace& face : rimOf(mesh_, place.tets))
  {
    const auto& v = face.vertex;
    faces.push_back({ numberOf(v[0]), numberOf(v[1]), numberOf(v[2]) });
  }
  for (const Index t : place.tets)
  {
    for (const Index v : mesh_.tet(t).vertex)
    {
      if (v != without)
      {
        numberOf(v);
      }
    }
  }
  if (numbers.count() > CavityFilling::MostPoints)
  {
    return false;
  }
  std::vector<Vector3> points;
  std::transform(place.vertices.begin(), place.vertices.end(), std::back_inserter(points),
    [this](Index v) { return mesh_.point(v); });
  place.filling.turnTo(points, faces);
  return true;
}

// The tetrahedra beyond the faces of these.
void RefillRemover::addRing(std::vector<Index>& tets) const
{
  LocalMarks inside;
  for (const Index t : tets)
  {
    inside.set(t);
  }
  const std::size_t before = tets.size();
  for (std::size_t i = 0; i < before; ++i)
  {
    for (const HalfFace beyond : mesh_.tet(tets[i]).neighbour)
    {
      if (!isBoundary(beyond) && inside.set(tetOf(beyond)))
      {
        tets.push_back(tetOf(beyond));
      }
    }
  }
}

CavityFilling::Verdict RefillRemover::tryAt(Place& place, double floor)
{
  constexpr std::size_t most = 5000;
  const std::size_t steps = std::min(most, stepsLeft_);
  const CavityFilling::Verdict verdict = place.filling.fill(floor, steps);
  stepsLeft_ -= steps - place.filling.stepsLeft();
  return verdict;
}

void RefillRemover::apply(const Place& place)
{
  std::vector<std::array<Index, 4>> fresh;
  for (const auto& tet : place.filling.tets())
  {
    fresh.push_back(
      { place.vertices[tet[0]], place.vertices[tet[1]], place.vertices[tet[2]], place.vertices[tet[3]] });
  }
  made_ = refill(mesh_, place.tets, fresh);
}
} // namespace ransmesh

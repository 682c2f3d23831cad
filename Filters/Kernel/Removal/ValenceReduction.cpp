#include "Removal/ValenceReduction.h"

#include <algorithm>
#include <limits>

namespace ransmesh
{
bool ValenceReduction::cutEdge(Index v, const RemovalLimits& limits)
{
  collectCuts(v, limits);
  std::stable_sort(
    cuts_.begin(), cuts_.end(), [](const Cut& a, const Cut& b) { return a.quality > b.quality; });
  return std::any_of(cuts_.begin(), cuts_.end(), [&](const Cut& cut) { return apply(v, cut); });
}

void ValenceReduction::collectCuts(Index v, const RemovalLimits& limits)
{
  cuts_.clear();
  traversal_.ball(v, ball_);
  seen_.clear(mesh_.vertexCount());
  seen_.set(v);
  for (const Index t : ball_)
  {
    for (const Index end : mesh_.tet(t).vertex)
    {
      if (seen_.set(end))
      {
        considerEdge(t, v, end, limits);
      }
    }
  }
}

// Begins the cavity with the ring of the edge (v, end); false if the edge must stay.
bool ValenceReduction::beginAt(Index tet, Index v, Index end)
{
  if (rules_.classification.ridges.has(v, end))
  {
    return false;
  }
  traversal_.ring(tet, v, end, ring_);
  cavity_.begin(ring_, { v, end });
  const auto& starred = cavity_.cavity().starredFaces;
  return std::all_of(starred.begin(), starred.end(),
    [this](Index b) { return rules_.changeable[mesh_.boundaryFace(b).patch] != 0; });
}

double ValenceReduction::floorFor(const RemovalLimits& limits) const
{
  double floor = limits.quality;
  if (limits.orNoWorse)
  {
    for (const Index t : ring_)
    {
      floor = std::min(floor, qualityOf(mesh_, t));
    }
  }
  return floor;
}

void ValenceReduction::considerEdge(Index tet, Index v, Index end, const RemovalLimits& limits)
{
  if (!beginAt(tet, v, end))
  {
    return;
  }
  apexes_.clear();
  for (const Index t : ring_)
  {
    for (const Index w : mesh_.tet(t).vertex)
    {
      if (w != v && w != end && std::find(apexes_.begin(), apexes_.end(), w) == apexes_.end())
      {
        apexes_.push_back(w);
      }
    }
  }
  Cut best{ end, None, floorFor(limits) };
  for (const Index apex : apexes_)
  {
    const double worst = cavity_.worstFrom(apex, best.quality);
    if (worst > best.quality && worst < std::numeric_limits<double>::infinity())
    {
      best = { end, apex, worst };
    }
  }
  if (best.apex != None)
  {
    cuts_.push_back(best);
  }
}

bool ValenceReduction::apply(Index v, const Cut& cut)
{
  const auto first =
    std::find_if(ball_.begin(), ball_.end(), [&](Index t) { return mesh_.tet(t).has(cut.end); });
  beginAt(*first, v, cut.end);
  const Cavity& cavity = cavity_.cavity();
  if (star_.check(cavity, cut.apex) != StarVerdict::Possible || !star_.lostVertices().empty())
  {
    return false;
  }
  if (!cavity.starredFaces.empty() &&
    surface_.judge(cavity.starredFaces, cut.apex, None) != RemovalVerdict::Collapsed)
  {
    return false;
  }
  made_ = &star_.apply();
  return true;
}
} // namespace ransmesh

#include "Removal/VertexRemover.h"

#include <algorithm>

namespace ransmesh
{
VertexRemover::VertexRemover(TetMesh& mesh, BoundaryRules& rules, LayerRegion& region, double cosine)
  : mesh_(mesh)
  , rules_(rules)
  , region_(region)
  , cosine_(cosine)
  , star_(mesh)
  , traversal_(mesh)
  , cavity_(mesh, rules)
  , surface_(mesh, rules.classification.ridges, cosine)
{
}

RemovalVerdict VertexRemover::remove(Index v, const RemovalLimits& limits)
{
  if (rules_.classification.kind[v] == VertexKind::Ridge && ridgeTurns(v))
  {
    return RemovalVerdict::SurfaceTurned;
  }
  begin(v);
  rankApexes(limits);
  RemovalVerdict verdict = RemovalVerdict::LowQuality;
  for (auto candidate = candidates_.rbegin(); candidate != candidates_.rend(); ++candidate)
  {
    worstFrom(candidate->apex, candidate->floor, limits);
    verdict = tryApex(v, candidate->apex);
    if (verdict == RemovalVerdict::Collapsed)
    {
      const bool enlarged = cavity_.cavity().tets.size() > ball_.size();
      return enlarged ? RemovalVerdict::RemovedWithCavity : verdict;
    }
  }
  return verdict;
}

void VertexRemover::begin(Index v)
{
  traversal_.ball(v, ball_);
  collectApexes(v);
  cavity_.begin(ball_, { v });
}

Index VertexRemover::nearestApex(Index v, const RemovalLimits& limits)
{
  begin(v);
  keepPromisingApexes(floorFor(limits), 1);
  return apexes_.front();
}

void VertexRemover::collectApexes(Index v)
{
  apexes_.clear();
  const VertexKind kind = rules_.classification.kind[v];
  if (kind == VertexKind::Ridge)
  {
    const auto ends = rules_.classification.ridges.at(v);
    apexes_.assign(ends.begin(), ends.end());
    return;
  }
  seen_.clear(mesh_.vertexCount());
  seen_.set(v);
  const auto add = [this](Index w)
  {
    if (seen_.set(w))
    {
      apexes_.push_back(w);
    }
  };
  for (const Index t : ball_)
  {
    const Tetrahedron& tet = mesh_.tet(t);
    if (kind == VertexKind::Volume)
    {
      std::for_each(tet.vertex.begin(), tet.vertex.end(), add);
      continue;
    }
    for (int f = 0; f < 4; ++f)
    {
      if (isBoundary(tet.neighbour[f]) && tet.vertex[f] != v)
      {
        const auto face = tet.face(f);
        std::for_each(face.begin(), face.end(), add);
      }
    }
  }
}

// Whether the ridge turns at v by more than a surface may.
bool VertexRemover::ridgeTurns(Index v) const
{
  const auto ends = rules_.classification.ridges.at(v);
  const Vector3 in = normalized(mesh_.point(v) - mesh_.point(ends[0]));
  const Vector3 out = normalized(mesh_.point(ends[1]) - mesh_.point(v));
  return !(dot(in, out) >= cosine_);
}

double VertexRemover::floorFor(const RemovalLimits& limits) const
{
  double floor = limits.quality;
  if (limits.keep > 0)
  {
    for (const Index t : ball_)
    {
      floor = std::min(floor, limits.keep * qualityOf(mesh_, t));
    }
  }
  return floor;
}

double VertexRemover::worstFrom(Index apex, double floor, const RemovalLimits& limits)
{
  return limits.growth == 0 ? cavity_.worstFrom(apex, floor) : cavity_.grow(apex, floor, limits.growth);
}

// The apexes that would do, each better than those before it.
void VertexRemover::rankApexes(const RemovalLimits& limits)
{
  candidates_.clear();
  double floor = floorFor(limits);
  if (limits.growth > 0)
  {
    constexpr std::size_t enough = 4; // growing costs much
    keepPromisingApexes(floor, enough);
  }
  for (const Index apex : apexes_)
  {
    const double worst = worstFrom(apex, floor, limits);
    if (worst > floor)
    {
      candidates_.push_back({ apex, floor });
      floor = worst;
    }
  }
}

// Keeps only the apexes that the fewest faces see badly.
void VertexRemover::keepPromisingApexes(double floor, std::size_t enough)
{
  ranking_.clear();
  for (const Index apex : apexes_)
  {
    ranking_.emplace_back(cavity_.countPoor(apex, floor), apex);
  }
  const std::size_t kept = std::min(enough, ranking_.size());
  std::partial_sort(ranking_.begin(), ranking_.begin() + static_cast<std::ptrdiff_t>(kept), ranking_.end());
  apexes_.resize(kept);
  std::transform(ranking_.begin(), ranking_.begin() + static_cast<std::ptrdiff_t>(kept), apexes_.begin(),
    [](const auto& entry) { return entry.second; });
}

RemovalVerdict VertexRemover::tryApex(Index v, Index apex)
{
  const Cavity& cavity = cavity_.cavity();
  if (star_.check(cavity, apex) != StarVerdict::Possible)
  {
    return RemovalVerdict::NotStarrable;
  }
  if (!losesOnlyMarked(v))
  {
    return RemovalVerdict::VertexLost;
  }
  if (isOverLarge(v, apex))
  {
    return RemovalVerdict::OverLarge;
  }
  if (!cavity.starredFaces.empty())
  {
    const RemovalVerdict verdict = surface_.judge(cavity.starredFaces, apex, v);
    if (verdict != RemovalVerdict::Collapsed)
    {
      return verdict;
    }
  }
  forgetLost(v, apex);
  made_ = &star_.apply();
  return RemovalVerdict::Collapsed;
}

// Points inside an enlarged cavity may go with v if they are to go anyway; ridge points go one by one.
bool VertexRemover::losesOnlyMarked(Index v) const
{
  const auto& lost = star_.lostVertices();
  const bool allMayGo = std::all_of(lost.begin(), lost.end(),
    [&](Index u)
    { return u == v || (region_.isMarked[u] && rules_.classification.kind[u] != VertexKind::Ridge); });
  return allMayGo && std::find(lost.begin(), lost.end(), v) != lost.end();
}

// An edge is too long if it is more than twice as long as the longest one that goes, and longer than
// the region is thick by far.
bool VertexRemover::isOverLarge(Index v, Index apex) const
{
  constexpr double byRegion = 2.5;
  constexpr double byCavity = 2;
  double longest = 0;
  for (const auto& tet : star_.newTets())
  {
    for (int i = 0; i < 3; ++i)
    {
      longest = std::max(longest, distance(mesh_.point(tet[i]), mesh_.point(apex)));
    }
  }
  if (longest <= byRegion * region_.reach[v])
  {
    return false;
  }
  double longestBefore = 0;
  for (const Index t : cavity_.cavity().tets)
  {
    const auto& w = mesh_.tet(t).vertex;
    for (int i = 0; i < 4; ++i)
    {
      for (int j = i + 1; j < 4; ++j)
      {
        longestBefore = std::max(longestBefore, distance(mesh_.point(w[i]), mesh_.point(w[j])));
      }
    }
  }
  return longest > byCavity * longestBefore;
}

// Takes away the marks of the points that go, and joins the ridge that v leaves.
void VertexRemover::forgetLost(Index v, Index apex)
{
  for (const Index u : star_.lostVertices())
  {
    region_.isMarked[u] = 0;
    absorbed_ += u != v;
  }
  if (rules_.classification.kind[v] != VertexKind::Ridge)
  {
    return;
  }
  Ridges& ridges = rules_.classification.ridges;
  const auto ends = ridges.at(v);
  const Index other = ends[0] == apex ? ends[1] : ends[0];
  ridges.remove(v, apex);
  ridges.remove(v, other);
  ridges.add(apex, other);
}
} // namespace ransmesh

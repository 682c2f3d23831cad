#include "Removal/VertexRemover.h"

#include "Mesh/Collapse.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace ransmesh
{
namespace
{
// An edge is too long if it is more than twice as long as the longest one that goes, and longer than
// the region is thick by far.
constexpr double farAsRegion = 2.5;
constexpr double farAsBefore = 2;
} // namespace

VertexRemover::VertexRemover(TetMesh& mesh, BoundaryRules& rules, LayerRegion& region, double cosine,
  SurfaceMemory& surfaces, SurfaceMemory& ridges)
  : mesh_(mesh)
  , rules_(rules)
  , region_(region)
  , cosine_(cosine)
  , star_(mesh)
  , link_(mesh)
  , surface_(mesh, rules, cosine, surfaces)
  , ridgeMemory_(ridges)
{
}

RemovalVerdict VertexRemover::remove(Index v, const RemovalLimits& limits)
{
  if (rules_.classification.kind[v] == VertexKind::Ridge)
  {
    if (ridgeTurns(v))
    {
      return RemovalVerdict::SurfaceTurned;
    }
    if (!ridgeStaysInPlace(v))
    {
      return RemovalVerdict::SurfaceMoved;
    }
  }
  look(v);
  const double floor = floorFor(limits);
  if (limits.growth > 0)
  {
    constexpr std::size_t enough = 4; // growing costs much
    keepPromisingEnds(v, floor, enough);
  }
  rank(v, floor, limits.growth);
  RemovalVerdict verdict = RemovalVerdict::LowQuality;
  for (auto candidate = candidates_.rbegin(); candidate != candidates_.rend(); ++candidate)
  {
    verdict = tryEnd(v, *candidate, limits);
    if (verdict == RemovalVerdict::Collapsed || verdict == RemovalVerdict::RemovedWithCavity)
    {
      break;
    }
  }
  return verdict;
}

bool VertexRemover::isNeededByShape(Index v, double wallAngle)
{
  const VertexKind kind = rules_.classification.kind[v];
  if (kind == VertexKind::Volume)
  {
    return false;
  }
  if (kind == VertexKind::Ridge && (ridgeTurns(v) || !ridgeStaysInPlace(v)))
  {
    return true;
  }
  look(v);
  return std::none_of(ends_.begin(), ends_.end(),
    [&](int end) { return judgeSurface(v, link_.ends()[end], wallAngle) == RemovalVerdict::Collapsed; });
}

double VertexRemover::floorAt(Index v, const RemovalLimits& limits)
{
  link_.turnTo(v);
  return floorFor(limits);
}

Index VertexRemover::nearestApex(Index v, const RemovalLimits& limits)
{
  look(v);
  keepPromisingEnds(v, floorFor(limits), 1);
  return link_.ends()[ends_.front()];
}

// Turns to v, and collects the ends to which it may go: along its own ridge or surface.
void VertexRemover::look(Index v)
{
  link_.turnTo(v);
  cavity_.starredFaces.clear();
  ends_.clear();
  const bool inVolume = rules_.classification.kind[v] == VertexKind::Volume;
  if (!inVolume)
  {
    collectSurfaceEnds(v);
  }
  const auto all = link_.ends();
  for (int end = 0; end < static_cast<int>(all.size()); ++end)
  {
    if (inVolume || std::find(surfaceEnds_.begin(), surfaceEnds_.end(), all[end]) != surfaceEnds_.end())
    {
      ends_.push_back(end);
    }
  }
}

// The boundary faces at v, and its neighbours along the surface or the ridge.
void VertexRemover::collectSurfaceEnds(Index v)
{
  surfaceEnds_.clear();
  for (const Index t : link_.ball())
  {
    const Tetrahedron& tet = mesh_.tet(t);
    for (int f = 0; f < 4; ++f)
    {
      if (tet.vertex[f] != v && isBoundary(tet.neighbour[f]))
      {
        cavity_.starredFaces.push_back(boundaryFaceOf(tet.neighbour[f]));
        const auto face = tet.face(f);
        surfaceEnds_.insert(surfaceEnds_.end(), face.begin(), face.end());
      }
    }
  }
  if (rules_.classification.kind[v] == VertexKind::Ridge)
  {
    const auto ends = rules_.classification.ridges.at(v);
    surfaceEnds_.assign(ends.begin(), ends.end());
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

// Whether the points that the ridge loses, with v and before, are near enough to the edge that closes it.
bool VertexRemover::ridgeStaysInPlace(Index v)
{
  const auto ends = rules_.classification.ridges.at(v);
  const Vector3& p = mesh_.point(v);
  const double mean = 0.5 * (distance(p, mesh_.point(ends[0])) + distance(p, mesh_.point(ends[1])));
  const SurfaceMemory::Piece old[] = { { ends[0], v, v }, { v, ends[1], ends[1] } };
  const SurfaceMemory::Piece edge{ ends[0], ends[1], ends[1] };
  const auto patches = rules_.classification.patchesAt(v);
  const bool ofWall =
    std::any_of(patches.begin(), patches.end(), [this](int patch) { return rules_.changeable[patch] == 0; });
  const double drift = ofWall ? largestWallDrift : largestSideDrift;
  return ridgeMemory_.allows(old, { &edge, 1 }, { &p, 1 }, drift * mean, ends[0]);
}

double VertexRemover::floorFor(const RemovalLimits& limits) const
{
  return limits.keep > 0 ? std::min(limits.quality, limits.keep * link_.worst()) : limits.quality;
}

// The ends that would do, the best one last. On surfaces all of them, as they may refuse for other reasons.
void VertexRemover::rank(Index v, double floor, std::size_t growth)
{
  candidates_.clear();
  if (rules_.classification.kind[v] != VertexKind::Volume)
  {
    rankAmong(ends_, false, floor, growth);
    std::stable_sort(candidates_.begin(), candidates_.end(),
      [](const Candidate& a, const Candidate& b) { return a.worst < b.worst; });
    return;
  }
  // Points that stay come first: those that go themselves would get more tetrahedra before, and go the harder.
  const std::size_t staying = endsThatStayFirst();
  const std::span<const int> ends = ends_;
  rankAmong(ends.first(staying), true, floor, growth);
  if (candidates_.empty())
  {
    rankAmong(ends.subspan(staying), true, floor, growth);
  }
}

void VertexRemover::rankAmong(std::span<const int> ends, bool onlyBetter, double floor, std::size_t growth)
{
  for (const int end : ends)
  {
    const double worst = growth == 0 ? link_.worstFrom(end, floor) : link_.grow(end, floor, growth, rules_);
    if (worst > floor)
    {
      candidates_.push_back({ end, floor, worst });
      floor = onlyBetter ? worst : floor;
    }
  }
}

// Keeps only the ends that the fewest faces see badly; of points in the volume, of those that stay if there are enough.
void VertexRemover::keepPromisingEnds(Index v, double floor, std::size_t enough)
{
  ranking_.clear();
  const bool inVolume = rules_.classification.kind[v] == VertexKind::Volume;
  const std::size_t staying = inVolume ? endsThatStayFirst() : ends_.size();
  for (std::size_t i = 0; i < ends_.size() && (i < staying || ranking_.size() < enough); ++i)
  {
    const std::size_t most =
      ranking_.size() < enough ? std::numeric_limits<std::size_t>::max() : ranking_.back().first;
    const std::pair<std::size_t, int> entry{ link_.countPoor(ends_[i], floor, most), ends_[i] };
    if (entry.first < most)
    {
      ranking_.insert(std::upper_bound(ranking_.begin(), ranking_.end(), entry), entry);
      ranking_.resize(std::min(enough, ranking_.size()));
    }
  }
  ends_.clear();
  std::transform(ranking_.begin(), ranking_.end(), std::back_inserter(ends_),
    [](const auto& entry) { return entry.second; });
}

// Puts the ends that stay before those that go themselves; how many stay.
std::size_t VertexRemover::endsThatStayFirst()
{
  const auto toGo = std::stable_partition(
    ends_.begin(), ends_.end(), [this](int end) { return !region_.isMarked[link_.ends()[end]]; });
  return static_cast<std::size_t>(toGo - ends_.begin());
}

RemovalVerdict VertexRemover::tryEnd(Index v, const Candidate& candidate, const RemovalLimits& limits)
{
  if (limits.growth > 0)
  {
    link_.grow(candidate.end, candidate.floor, limits.growth, rules_);
    if (!link_.grownTets().empty() || !link_.grownStarred().empty())
    {
      return tryCavity(v, candidate, limits.wallAngle);
    }
  }
  return tryCollapse(v, candidate, limits.wallAngle);
}

// Collapsed if the surface allows it.
RemovalVerdict VertexRemover::judgeSurface(Index v, Index apex, double wallAngle)
{
  changesSurface_ = !cavity_.starredFaces.empty();
  if (!changesSurface_)
  {
    return RemovalVerdict::Collapsed;
  }
  const RemovalVerdict verdict = surface_.judge(cavity_.starredFaces, apex, v);
  const auto wall = region_.wallNormal.find(v);
  return verdict == RemovalVerdict::Collapsed && wall != region_.wallNormal.end()
    ? surface_.judgeShape(cavity_.starredFaces, apex, wall->second, wallAngle)
    : verdict;
}

RemovalVerdict VertexRemover::tryCollapse(Index v, const Candidate& candidate, double wallAngle)
{
  const Index apex = link_.ends()[candidate.end];
  if (collapseIsOverLarge(v, candidate.end))
  {
    return RemovalVerdict::OverLarge;
  }
  if (!canCollapse(mesh_, link_.ball(), v, apex) || !link_.allPositiveFrom(candidate.end))
  {
    return RemovalVerdict::NotStarrable;
  }
  const RemovalVerdict ofSurface = judgeSurface(v, apex, wallAngle);
  if (ofSurface != RemovalVerdict::Collapsed)
  {
    return ofSurface;
  }
  forget(v, apex);
  collapse(mesh_, link_.ball(), v, apex);
  made_.clear();
  std::copy_if(link_.ball().begin(), link_.ball().end(), std::back_inserter(made_),
    [this](Index t) { return mesh_.tet(t).isAlive(); });
  worstMade_ = candidate.worst;
  return RemovalVerdict::Collapsed;
}

RemovalVerdict VertexRemover::tryCavity(Index v, const Candidate& candidate, double wallAngle)
{
  const Index apex = link_.ends()[candidate.end];
  const std::size_t starredAtV = cavity_.starredFaces.size();
  const auto addTo = [](std::vector<Index>& all, const std::vector<Index>& more)
  { all.insert(all.end(), more.begin(), more.end()); };
  cavity_.tets.assign(link_.ball().begin(), link_.ball().end());
  addTo(cavity_.tets, link_.grownTets());
  addTo(cavity_.starredFaces, link_.grownStarred());
  RemovalVerdict verdict = RemovalVerdict::RemovedWithCavity;
  if (star_.check(cavity_, apex) != StarVerdict::Possible)
  {
    verdict = RemovalVerdict::NotStarrable;
  }
  else if (!losesOnlyMarked(v))
  {
    verdict = RemovalVerdict::VertexLost;
  }
  else if (cavityIsOverLarge(v, apex))
  {
    verdict = RemovalVerdict::OverLarge;
  }
  else
  {
    const RemovalVerdict ofSurface = judgeSurface(v, apex, wallAngle);
    verdict = ofSurface == RemovalVerdict::Collapsed ? verdict : ofSurface;
  }
  cavity_.starredFaces.resize(starredAtV);
  if (verdict == RemovalVerdict::RemovedWithCavity)
  {
    absorbed_ += star_.lostVertices().size() - 1;
    for (const Index lost : star_.lostVertices())
    {
      region_.isMarked[lost] = 0;
    }
    forget(v, apex);
    made_ = star_.apply();
    worstMade_ = candidate.worst;
  }
  return verdict;
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

bool VertexRemover::collapseIsOverLarge(Index v, int end) const
{
  const auto places = link_.places();
  double longest = 0;
  double longestBefore = 0;
  for (const Vector3& place : places)
  {
    const Vector3 edge = place - places[end];
    longest = std::max(longest, dot(edge, edge));
    longestBefore = std::max(longestBefore, dot(place, place));
  }
  longest = std::sqrt(longest);
  return longest > farAsRegion * region_.reach[v] && longest > farAsBefore * std::sqrt(longestBefore);
}

bool VertexRemover::cavityIsOverLarge(Index v, Index apex) const
{
  double longest = 0;
  for (const auto& tet : star_.newTets())
  {
    for (int i = 0; i < 3; ++i)
    {
      longest = std::max(longest, distance(mesh_.point(tet[i]), mesh_.point(apex)));
    }
  }
  if (longest <= farAsRegion * region_.reach[v])
  {
    return false;
  }
  double longestBefore = 0;
  for (const Index t : cavity_.tets)
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
  return longest > farAsBefore * longestBefore;
}

// Takes away v's mark, remembers it where it lay on a surface, and joins the ridge that it leaves.
void VertexRemover::forget(Index v, Index apex)
{
  region_.isMarked[v] = 0;
  if (changesSurface_)
  {
    surface_.remember();
  }
  if (rules_.classification.kind[v] != VertexKind::Ridge)
  {
    return;
  }
  Ridges& ridges = rules_.classification.ridges;
  const auto ends = ridges.at(v);
  const Index other = ends[0] == apex ? ends[1] : ends[0];
  ridgeMemory_.remember();
  ridges.remove(v, apex);
  ridges.remove(v, other);
  ridges.add(apex, other);
}
} // namespace ransmesh

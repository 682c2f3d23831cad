#include "Removal/ValenceReduction.h"

#include <algorithm>
#include <limits>

namespace ransmesh
{
void ValenceReduction::begin(Index v, const RemovalLimits& limits)
{
  vertex_ = v;
  limits_ = limits;
  onWall_ = false;
  lookAtAllEdges();
}

void ValenceReduction::beginOnWall(Index v, const RemovalLimits& limits, const Vector3& normal)
{
  vertex_ = v;
  limits_ = limits;
  onWall_ = true;
  wallNormal_ = normal;
  lookAtAllEdges();
}

bool ValenceReduction::swapOnWall(Index v, Index end, const RemovalLimits& limits, const Vector3& normal)
{
  const std::vector<char>& frozen = rules_.classification.frozen;
  if (frozen[v] && frozen[end]) // perhaps on an interface, whose triangles stay
  {
    return false;
  }
  vertex_ = v;
  limits_ = limits;
  onWall_ = true;
  wallNormal_ = normal;
  traversal_.ball(v, ball_);
  const Cut cut = bestCut(tetWith(end), end);
  return cut.apex != None && apply(cut);
}

void ValenceReduction::lookAtAllEdges()
{
  cuts_.clear();
  traversal_.ball(vertex_, ball_);
  seen_.clear();
  seen_.set(vertex_);
  for (const Index t : ball_)
  {
    for (const Index end : mesh_.tet(t).vertex)
    {
      if (seen_.set(end))
      {
        cuts_.push_back(bestCut(t, end));
      }
    }
  }
}

bool ValenceReduction::cutEdge()
{
  for (;;)
  {
    const auto best = std::max_element(
      cuts_.begin(), cuts_.end(), [](const Cut& a, const Cut& b) { return a.quality < b.quality; });
    if (best == cuts_.end() || best->apex == None)
    {
      return false;
    }
    const Cut cut = *best;
    cuts_.erase(best);
    if (apply(cut))
    {
      lookAgain();
      return true;
    }
  }
}

// A tetrahedron at the edge from the vertex to end, out of ball_.
Index ValenceReduction::tetWith(Index end) const
{
  return *std::find_if(ball_.begin(), ball_.end(), [&](Index t) { return mesh_.tet(t).has(end); });
}

// Begins the cavity with the ring of the edge to end; false if the edge must stay.
bool ValenceReduction::beginAt(Index tet, Index end)
{
  if (rules_.classification.ridges.has(vertex_, end))
  {
    return false;
  }
  traversal_.ring(tet, vertex_, end, ring_);
  cavity_.turnTo(ring_, { vertex_, end });
  const auto& starred = cavity_.cavity().starredFaces;
  return std::all_of(starred.begin(), starred.end(),
    [this](Index b) { return onWall_ || rules_.changeable[mesh_.boundaryFace(b).patch] != 0; });
}

// Whether the surface stays where it is if it is starred from the apex: only a vertex of the faces that
// go will do.
bool ValenceReduction::maySee(Index apex) const
{
  const auto& starred = cavity_.cavity().starredFaces;
  return starred.empty() ||
    std::any_of(starred.begin(), starred.end(),
      [&](Index b)
      {
        const auto v = mesh_.boundaryVertices(b);
        return v[0] == apex || v[1] == apex || v[2] == apex;
      });
}

double ValenceReduction::floorFor() const
{
  double floor = limits_.quality;
  if (limits_.keep > 0)
  {
    for (const Index t : ring_)
    {
      floor = std::min(floor, limits_.keep * qualityOf(mesh_, t));
    }
  }
  return floor;
}

// What the edge from the vertex to end would best be replaced by.
ValenceReduction::Cut ValenceReduction::bestCut(Index tet, Index end)
{
  constexpr std::size_t largestRing = 6;
  Cut best{ end, None, -1 };
  if (!beginAt(tet, end) || ring_.size() > largestRing)
  {
    return best;
  }
  apexes_.clear();
  for (const Index t : ring_)
  {
    for (const Index w : mesh_.tet(t).vertex)
    {
      if (w != vertex_ && w != end && maySee(w) &&
        std::find(apexes_.begin(), apexes_.end(), w) == apexes_.end())
      {
        apexes_.push_back(w);
      }
    }
  }
  double floor = floorFor();
  for (const Index apex : apexes_)
  {
    const double worst = cavity_.worstFrom(apex, floor);
    if (worst > floor && worst < std::numeric_limits<double>::infinity())
    {
      best = { end, apex, worst };
      floor = worst;
    }
  }
  return best;
}

// Collapsed if the surface allows the cut, whose cavity has been turned to.
RemovalVerdict ValenceReduction::judgeSurface(const Cut& cut)
{
  const auto& starred = cavity_.cavity().starredFaces;
  const RemovalVerdict verdict = surface_.judge(starred, cut.apex, None);
  return verdict == RemovalVerdict::Collapsed && onWall_
    ? surface_.judgeShape(starred, cut.apex, wallNormal_, limits_.wallAngle)
    : verdict;
}

bool ValenceReduction::apply(const Cut& cut)
{
  beginAt(tetWith(cut.end), cut.end);
  const Cavity& cavity = cavity_.cavity();
  if (star_.check(cavity, cut.apex) != StarVerdict::Possible || !star_.lostVertices().empty())
  {
    return false;
  }
  if (!cavity.starredFaces.empty())
  {
    if (judgeSurface(cut) != RemovalVerdict::Collapsed)
    {
      return false;
    }
    surface_.remember();
  }
  seen_.clear();
  for (const Index t : ring_)
  {
    for (const Index w : mesh_.tet(t).vertex)
    {
      seen_.set(w);
    }
  }
  made_ = &star_.apply();
  return true;
}

// Judges the edges again whose rings have changed: those to the vertices of the ring, marked as seen.
void ValenceReduction::lookAgain()
{
  traversal_.ball(vertex_, ball_);
  for (Cut& cut : cuts_)
  {
    if (seen_.test(cut.end))
    {
      cut = bestCut(tetWith(cut.end), cut.end);
    }
  }
}
} // namespace ransmesh

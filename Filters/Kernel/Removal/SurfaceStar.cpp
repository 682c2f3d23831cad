#include "Removal/SurfaceStar.h"

#include "Geometry/Angles.h"

#include <algorithm>
#include <iterator>

namespace ransmesh
{
namespace
{
Vector3 normalOf(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return normalized(cross(b - a, c - a));
}
} // namespace

bool SurfaceStar::turnsTooFar(const EdgeUse& rim, Index apex) const
{
  const auto v = mesh_.boundaryVertices(rim.face);
  const Vector3 old = normalOf(mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]));
  const Vector3 now = normalOf(mesh_.point(rim.way[0]), mesh_.point(rim.way[1]), mesh_.point(apex));
  return !(dot(old, now) >= cosine_);
}

// Whether a new edge is an edge of the surface elsewhere already: the surface would touch itself.
bool SurfaceStar::meetsSurfaceAgain(std::span<const Index> faces, Index apex)
{
  traversal_.ball(apex, ball_);
  for (const Index t : ball_)
  {
    const Tetrahedron& tet = mesh_.tet(t);
    for (int f = 0; f < 4; ++f)
    {
      const HalfFace beyond = tet.neighbour[f];
      if (!isBoundary(beyond) || tet.vertex[f] == apex ||
        std::find(faces.begin(), faces.end(), boundaryFaceOf(beyond)) != faces.end())
      {
        continue;
      }
      for (const Index v : tet.face(f))
      {
        if (v != apex && std::find(newEnds_.begin(), newEnds_.end(), v) != newEnds_.end())
        {
          return true;
        }
      }
    }
  }
  return false;
}

// The edges between two of the faces vanish, the others are the rim.
RemovalVerdict SurfaceStar::judgeEdges(Index apex, Index vanishing)
{
  inner_.clear();
  newEnds_.clear();
  newBases_.clear();
  rimAtApex_.clear();
  for (std::size_t i = 0; i < edges_.size(); ++i)
  {
    const EdgeUse& edge = edges_[i];
    const bool shared = i + 1 < edges_.size() && edges_[i + 1].isSameEdge(edge);
    if (shared)
    {
      const bool goesWithItsVertex = edge.low == vanishing || edge.high == vanishing;
      if (rules_.classification.ridges.has(edge.low, edge.high) && !goesWithItsVertex)
      {
        return RemovalVerdict::RidgeLost;
      }
      inner_.push_back(edge.way);
      ++i;
    }
    else if (edge.low == apex || edge.high == apex)
    {
      rimAtApex_.push_back(edge.low == apex ? edge.high : edge.low);
    }
    else if (turnsTooFar(edge, apex))
    {
      return RemovalVerdict::SurfaceTurned;
    }
    else
    {
      newBases_.push_back(edge.way);
      newEnds_.push_back(edge.low);
      newEnds_.push_back(edge.high);
    }
  }
  return RemovalVerdict::Collapsed;
}

// Whether the points that are lost with the faces, and those lost before, are near enough to the new ones. An
// edge that goes although both its ends stay is lost with its middle.
bool SurfaceStar::staysInPlace(std::span<const Index> faces, Index apex)
{
  old_.clear();
  new_.clear();
  lost_.clear();
  std::transform(faces.begin(), faces.end(), std::back_inserter(old_),
    [this](Index b) { return mesh_.boundaryVertices(b); });
  std::transform(newBases_.begin(), newBases_.end(), std::back_inserter(new_),
    [apex](const auto& base) {
      return SurfaceMemory::Piece{ base[0], base[1], apex };
    });
  const auto stays = [&](Index v)
  { return v == apex || std::find(newEnds_.begin(), newEnds_.end(), v) != newEnds_.end(); };
  double length = 0;
  for (const auto& [from, to] : inner_)
  {
    const Vector3& a = mesh_.point(from);
    const Vector3& b = mesh_.point(to);
    length += distance(a, b);
    const Vector3 lost = stays(from) && stays(to) ? 0.5 * (a + b) : stays(from) ? b : a;
    if (std::find(lost_.begin(), lost_.end(), lost) == lost_.end())
    {
      lost_.push_back(lost);
    }
  }
  const bool ofWall = std::any_of(faces.begin(), faces.end(),
    [this](Index b) { return rules_.changeable[mesh_.boundaryFace(b).patch] == 0; });
  const double drift = ofWall ? largestWallDrift : largestSideDrift;
  const auto count = static_cast<double>(std::max<std::size_t>(1, inner_.size()));
  return memory_.allows(old_, new_, lost_, drift * length / count, apex);
}

RemovalVerdict SurfaceStar::judge(std::span<const Index> faces, Index apex, Index vanishing)
{
  collectEdgeUses(mesh_, faces, edges_);
  const RemovalVerdict verdict = judgeEdges(apex, vanishing);
  if (verdict != RemovalVerdict::Collapsed)
  {
    return verdict;
  }
  if (!staysInPlace(faces, apex))
  {
    return RemovalVerdict::SurfaceMoved;
  }
  std::erase_if(newEnds_,
    [this](Index v) { return std::find(rimAtApex_.begin(), rimAtApex_.end(), v) != rimAtApex_.end(); });
  return meetsSurfaceAgain(faces, apex) ? RemovalVerdict::SurfaceTurned : RemovalVerdict::Collapsed;
}

RemovalVerdict SurfaceStar::judgeShape(
  std::span<const Index> faces, Index apex, const Vector3& normal, double angle) const
{
  double allowed = angle;
  for (const Index b : faces)
  {
    const auto v = mesh_.boundaryVertices(b);
    allowed = std::max(allowed, largestAngle(mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2])));
  }
  const Vector3& top = mesh_.point(apex);
  for (const auto& [from, to] : newBases_)
  {
    const Vector3& a = mesh_.point(from);
    const Vector3& b = mesh_.point(to);
    if (normal != Vector3{} && !(dot(normalOf(a, b, top), normal) >= cosine_))
    {
      return RemovalVerdict::SurfaceTurned;
    }
    if (largestAngle(a, b, top) > allowed)
    {
      return RemovalVerdict::PoorTriangle;
    }
  }
  return RemovalVerdict::Collapsed;
}
} // namespace ransmesh

#include "Insertion/SideStar.h"

#include <algorithm>
#include <iterator>

namespace ransmesh
{
void SideStar::remember(const Column& column, const std::vector<Index>& ball)
{
  faces_.clear();
  if (!turns_.anyCurved() || column.sides[0] == 0)
  {
    return;
  }
  for (const Index t : ball)
  {
    const Tetrahedron& tet = mesh_.tet(t);
    for (int f = 0; f < 4; ++f)
    {
      const HalfFace beyond = tet.neighbour[f];
      if (isBoundary(beyond) && tet.vertex[f] != column.vertex && column.staysIn(mesh_.patchOf(beyond)) &&
        turns_.isCurved(mesh_.patchOf(beyond)))
      {
        const Index face = boundaryFaceOf(beyond);
        faces_.push_back({ face, turns_.faithfulness(face) });
      }
    }
  }
}

bool SideStar::allowsMove() const
{
  return std::all_of(faces_.begin(), faces_.end(),
    [this](const Face& face) { return turns_.allows(turns_.faithfulness(face.number), face.before); });
}

bool SideStar::allowsStar(const Cavity& cavity, Index top, const std::vector<Index>& lost)
{
  if (cavity.starredFaces.empty())
  {
    return true;
  }
  collectEdgeUses(mesh_, cavity.starredFaces, edges_);
  rim_.clear();
  for (std::size_t i = 0; i < edges_.size(); ++i)
  {
    const EdgeUse& edge = edges_[i];
    const bool shared =
      i + 1 < edges_.size() && edges_[i + 1].low == edge.low && edges_[i + 1].high == edge.high;
    if (shared ? !mayVanish(edge, edges_[i + 1], top, lost) : !rimAllows(edge, top))
    {
      return false;
    }
    if (shared)
    {
      ++i;
      continue;
    }
    rim_.push_back(edge.low);
    rim_.push_back(edge.high);
  }
  return hangTogether(cavity.starredFaces, top) && keepsVertices(cavity.starredFaces, top, lost);
}

// From the faces at the top across shared edges to all others: a patch may lie on both sides of a narrow
// fluid, and only one of them is the top's.
bool SideStar::hangTogether(const std::vector<Index>& faces, Index top) const
{
  const auto has = [](const std::vector<Index>& list, Index v)
  { return std::find(list.begin(), list.end(), v) != list.end(); };
  std::vector<Index> reached;
  std::copy_if(faces.begin(), faces.end(), std::back_inserter(reached),
    [&](Index face)
    {
      const auto corners = mesh_.boundaryVertices(face);
      return std::find(corners.begin(), corners.end(), top) != corners.end();
    });
  for (bool grown = true; grown;)
  {
    grown = false;
    for (std::size_t i = 0; i + 1 < edges_.size(); ++i)
    {
      const EdgeUse& one = edges_[i];
      const EdgeUse& other = edges_[i + 1];
      const bool shared = one.isSameEdge(other);
      if (shared && has(reached, one.face) != has(reached, other.face))
      {
        reached.push_back(has(reached, one.face) ? other.face : one.face);
        grown = true;
      }
    }
  }
  return reached.size() == faces.size();
}

double SideStar::faithfulnessBefore(Index face) const
{
  const auto known =
    std::find_if(faces_.begin(), faces_.end(), [face](const Face& f) { return f.number == face; });
  return known != faces_.end() ? known->before : turns_.faithfulness(face);
}

bool SideStar::rimAllows(const EdgeUse& rim, Index top) const
{
  const int patch = mesh_.boundaryFace(rim.face).patch;
  if (rim.low == top || rim.high == top || !turns_.isCurved(patch))
  {
    return true;
  }
  const double now = turns_.faithfulness(patch, { rim.way[0], rim.way[1], top },
    { mesh_.point(rim.way[0]), mesh_.point(rim.way[1]), mesh_.point(top) });
  return turns_.allows(now, faithfulnessBefore(rim.face));
}

bool SideStar::mayVanish(
  const EdgeUse& one, const EdgeUse& other, Index top, const std::vector<Index>& lost) const
{
  const auto goes = [&](Index v) { return v == top || std::find(lost.begin(), lost.end(), v) != lost.end(); };
  if (goes(one.low) || goes(one.high))
  {
    return true;
  }
  return mesh_.boundaryFace(one.face).patch == mesh_.boundaryFace(other.face).patch &&
    !classes_.ridges.has(one.low, one.high);
}

bool SideStar::mayLose(const Column& column, Index vertex) const
{
  const auto patches = classes_.patchesAt(vertex);
  const bool inSides =
    std::all_of(patches.begin(), patches.end(), [&column](int p) { return column.staysIn(p); });
  if (classes_.frozen[vertex] || !inSides)
  {
    return false;
  }
  if (classes_.kind[vertex] == VertexKind::Surface)
  {
    return patches.size() == 1;
  }
  return classes_.kind[vertex] == VertexKind::Ridge && column.sides[1] != 0 &&
    ridgeGoesOn(column.vertex, vertex);
}

// Is the vertex the next one on the top's ridge, and does the ridge go on in the same direction without it?
bool SideStar::ridgeGoesOn(Index top, Index vertex) const
{
  const auto ends = classes_.ridges.at(vertex);
  const auto isBehind = [&](Index end) { return end == top || mesh_.tetAt(end) == None; };
  if (ends.size() != 2 || isBehind(ends[0]) == isBehind(ends[1]))
  {
    return false;
  }
  const Vector3& ahead = mesh_.point(isBehind(ends[0]) ? ends[1] : ends[0]);
  const double cosine = dot(normalized(ahead - mesh_.point(top)), normalized(ahead - mesh_.point(vertex)));
  return turns_.allows(cosine, 1);
}

bool SideStar::keepsVertices(const std::vector<Index>& faces, Index top, const std::vector<Index>& lost) const
{
  const auto has = [](const std::vector<Index>& list, Index v)
  { return std::find(list.begin(), list.end(), v) != list.end(); };
  return std::all_of(faces.begin(), faces.end(),
    [&](Index face)
    {
      const auto corners = mesh_.boundaryVertices(face);
      return std::all_of(
        corners.begin(), corners.end(), [&](Index v) { return v == top || has(rim_, v) || has(lost, v); });
    });
}
} // namespace ransmesh

#include "Mesh/Star.h"

#include "Geometry/Predicates.h"

#include <algorithm>

namespace ransmesh
{
const char* nameOf(StarVerdict verdict)
{
  switch (verdict)
  {
    case StarVerdict::Possible:
      return "possible";
    case StarVerdict::Empty:
      return "empty";
    case StarVerdict::NotPositive:
      return "not positive";
    case StarVerdict::EdgeNotManifold:
      return "edge not manifold";
    case StarVerdict::GluedToNothing:
      return "glued to nothing";
    default:
      return "unknown";
  }
}

StarVerdict Star::check(const Cavity& cavity, Index apex)
{
  collectTets(cavity);
  collectFaces(cavity, apex);
  if (newTets_.empty())
  {
    return StarVerdict::Empty;
  }
  if (!allPositive(apex))
  {
    return StarVerdict::NotPositive;
  }
  if (!pairEdges(apex))
  {
    return StarVerdict::EdgeNotManifold;
  }
  if (someGluedToNothing())
  {
    return StarVerdict::GluedToNothing;
  }
  findLostVertices(apex);
  return StarVerdict::Possible;
}

void Star::collectTets(const Cavity& cavity)
{
  tets_.clear();
  inCavity_.clear();
  for (const Index t : cavity.tets)
  {
    if (inCavity_.set(t))
    {
      tets_.push_back(t);
    }
  }
}

void Star::collectFaces(const Cavity& cavity, Index apex)
{
  isStarred_.clear();
  for (const Index b : cavity.starredFaces)
  {
    isStarred_.set(b);
  }
  faces_.clear();
  newTets_.clear();
  for (const Index t : tets_)
  {
    const Tetrahedron& tet = mesh_.tet(t);
    for (int f = 0; f < 4; ++f)
    {
      const HalfFace beyond = tet.neighbour[f];
      if (!isBoundary(beyond) && inCavity_.test(tetOf(beyond)))
      {
        continue;
      }
      OuterFace face{ halfFace(t, f), beyond, tet.face(f), Kind::New, None };
      const auto& v = face.vertex;
      if (isBoundary(beyond) && isStarred_.test(boundaryFaceOf(beyond)))
      {
        face.kind = Kind::Starred;
      }
      else if (v[0] == apex || v[1] == apex || v[2] == apex)
      {
        face.kind = Kind::Glued;
      }
      else
      {
        face.created = static_cast<Index>(newTets_.size());
        newTets_.push_back({ v[0], v[1], v[2], apex });
      }
      faces_.push_back(face);
    }
  }
}

bool Star::allPositive(Index apex) const
{
  const Vector3& q = mesh_.point(apex);
  return std::all_of(newTets_.begin(), newTets_.end(),
    [&](const std::array<Index, 4>& v)
    { return isPositive(mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]), q); });
}

bool Star::pairEdges(Index apex)
{
  edgeNumbers_.clear();
  edges_.clear();
  for (std::size_t i = 0; i < faces_.size(); ++i)
  {
    const auto& v = faces_[i].vertex;
    for (int j = 0; j < 3; ++j)
    {
      const Index a = v[(j + 1) % 3];
      const Index b = v[(j + 2) % 3];
      if (a == apex || b == apex)
      {
        continue;
      }
      const auto low = static_cast<std::uint64_t>(std::min(a, b));
      const std::uint64_t ends = low << 32 | static_cast<std::uint64_t>(std::max(a, b));
      const auto number = static_cast<std::size_t>(edgeNumbers_.add(ends));
      const EdgeUse use{ static_cast<Index>(i), j };
      if (number == edges_.size())
      {
        edges_.push_back({ ends, use, use, 1 });
      }
      else if (++edges_[number].uses > 2)
      {
        return false;
      }
      edges_[number].second = use;
    }
  }
  return std::all_of(edges_.begin(), edges_.end(), [](const Edge& edge) { return edge.uses == 2; });
}

bool Star::someGluedToNothing() const
{
  // What stands beyond a glued face must meet a tetrahedron.
  const auto leavesNothing = [](const OuterFace& face)
  { return face.kind == Kind::Starred || (face.kind == Kind::Glued && isBoundary(face.beyond)); };
  for (const Edge& edge : edges_)
  {
    const OuterFace& a = faces_[edge.first.face];
    const OuterFace& b = faces_[edge.second.face];
    const bool someGlued = a.kind == Kind::Glued || b.kind == Kind::Glued;
    if (someGlued && leavesNothing(a) && leavesNothing(b))
    {
      return true;
    }
  }
  return false;
}

void Star::findLostVertices(Index apex)
{
  kept_.clear();
  kept_.set(apex);
  for (const OuterFace& face : faces_)
  {
    if (face.kind != Kind::Starred)
    {
      for (const Index v : face.vertex)
      {
        kept_.set(v);
      }
    }
  }
  lost_.clear();
  for (const Index t : tets_)
  {
    for (const Index v : mesh_.tet(t).vertex)
    {
      if (kept_.set(v))
      {
        lost_.push_back(v);
      }
    }
  }
}

// New boundary faces get their numbers in the order of their edges, in whichever order the cavity was given.
void Star::sortBoundaryEdges()
{
  const auto isStarred = [this](const EdgeUse& use) { return faces_[use.face].kind == Kind::Starred; };
  const auto end = std::partition(edges_.begin(), edges_.end(),
    [&](const Edge& edge) { return isStarred(edge.first) || isStarred(edge.second); });
  std::sort(edges_.begin(), end, [](const Edge& a, const Edge& b) { return a.ends < b.ends; });
}

HalfFace Star::createdSide(const EdgeUse& use) const
{
  return halfFace(created_[faces_[use.face].created], use.corner);
}

void Star::join(const EdgeUse& first, const EdgeUse& second)
{
  const bool ordered = faces_[first.face].kind <= faces_[second.face].kind;
  const EdgeUse& a = ordered ? first : second; // New before Starred before Glued
  const EdgeUse& b = ordered ? second : first;
  const OuterFace& fa = faces_[a.face];
  const OuterFace& fb = faces_[b.face];
  if (fa.kind == Kind::New && fb.kind == Kind::New)
  {
    mesh_.link(createdSide(a), createdSide(b));
  }
  else if (fa.kind == Kind::New && fb.kind == Kind::Starred)
  {
    mesh_.addBoundaryFace(createdSide(a), mesh_.patchOf(fb.beyond));
  }
  else if (fa.kind == Kind::New)
  {
    mesh_.link(createdSide(a), fb.beyond);
  }
  else if (fa.kind == Kind::Starred && fb.kind == Kind::Glued)
  {
    mesh_.addBoundaryFace(fb.beyond, mesh_.patchOf(fa.beyond));
  }
  else if (fa.kind == Kind::Glued)
  {
    mesh_.link(fa.beyond, fb.beyond);
  }
}

const std::vector<Index>& Star::apply()
{
  created_.clear();
  for (const auto& v : newTets_)
  {
    created_.push_back(mesh_.addTet(v));
  }
  for (const OuterFace& face : faces_)
  {
    if (face.kind == Kind::New)
    {
      mesh_.link(halfFace(created_[face.created], 3), face.beyond);
    }
  }
  sortBoundaryEdges();
  for (const Edge& edge : edges_)
  {
    join(edge.first, edge.second);
  }
  for (const OuterFace& face : faces_)
  {
    if (face.kind == Kind::Glued && !isBoundary(face.beyond))
    {
      for (const Index v : mesh_.tet(tetOf(face.beyond)).vertex)
      {
        mesh_.setVertexTet(v, tetOf(face.beyond));
      }
    }
    if (face.kind == Kind::Starred)
    {
      mesh_.freeBoundaryFace(boundaryFaceOf(face.beyond));
    }
  }
  for (const Index v : lost_)
  {
    mesh_.setVertexTet(v, None);
  }
  for (const Index t : tets_)
  {
    mesh_.freeTet(t);
  }
  return created_;
}
} // namespace ransmesh

#include "Insertion/JointMove.h"

#include "Geometry/TetrahedronMeasures.h"
#include "Insertion/FrontMoves.h"

#include <algorithm>

namespace ransmesh
{
std::size_t JointMove::run(const std::vector<double>& target)
{
  place(target);
  const std::vector<Index> tets = tetsAtMovedTops();
  const std::vector<Index> sideFaces = sideFacesAtMovedTops();
  // What is taken back changes its neighbours' tetrahedra: again, until all are well. In the worst case
  // every top is back where it was.
  round_ = 1;
  for (bool again = true; again; ++round_)
  {
    const bool folded = takeBackAtFoldedFaces();
    const bool spoiled = takeBackAtSpoiledTets(tets);
    const bool turned = takeBackAtTurnedFaces(sideFaces);
    again = folded || spoiled || turned;
  }
  return static_cast<std::size_t>(std::count(moved_.begin(), moved_.end(), 1));
}

void JointMove::place(const std::vector<double>& target)
{
  const std::size_t count = set_.columns.size();
  moved_.assign(mesh_.vertexCount(), 0);
  lastChange_.assign(mesh_.vertexCount(), Never);
  oldShare_.resize(count);
  oldPosition_.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto c = static_cast<Index>(i);
    const Index vertex = set_.columns[i].vertex;
    oldShare_[i] = front_.share(c);
    oldPosition_[i] = mesh_.point(vertex);
    if (target[i] > oldShare_[i])
    {
      moved_[vertex] = 1;
      lastChange_[vertex] = 0;
      front_.setShare(c, target[i]);
      mesh_.movePoint(vertex, front_.position(c, target[i]));
    }
  }
}

bool JointMove::isConcerned(std::span<const Index> vertices) const
{
  int latest = Never;
  int moved = 0; // without branches: whether a vertex moved is a toss
  for (const Index v : vertices)
  {
    latest = std::max(latest, lastChange_[v]);
    moved |= moved_[v];
  }
  return moved != 0 && latest >= round_ - 1;
}

std::vector<Index> JointMove::tetsAtMovedTops() const
{
  std::vector<Index> tets;
  for (std::size_t i = 0; i < mesh_.tetSlots(); ++i)
  {
    const Tetrahedron& tet = mesh_.tet(static_cast<Index>(i));
    if (tet.isAlive() &&
      std::any_of(tet.vertex.begin(), tet.vertex.end(), [this](Index v) { return hasMoved(v); }))
    {
      tets.push_back(static_cast<Index>(i));
    }
  }
  return tets;
}

bool JointMove::takeBackAtFoldedFaces()
{
  bool any = false;
  for (const BaseFace& face : front_.faces())
  {
    if (isConcerned(face.vertex) && !front_.slabIsPositive(face))
    {
      std::for_each(face.vertex.begin(), face.vertex.end(), [this](Index v) { takeBack(v); });
      any = true;
    }
  }
  return any;
}

std::vector<Index> JointMove::sideFacesAtMovedTops() const
{
  std::vector<Index> faces;
  for (std::size_t i = 0; turns_.anyCurved() && i < mesh_.boundarySlots(); ++i)
  {
    const auto b = static_cast<Index>(i);
    if (!mesh_.boundaryFace(b).isAlive() || !turns_.isCurved(mesh_.boundaryFace(b).patch))
    {
      continue;
    }
    const auto v = mesh_.boundaryVertices(b);
    if (std::any_of(v.begin(), v.end(), [this](Index w) { return hasMoved(w); }))
    {
      faces.push_back(b);
    }
  }
  return faces;
}

bool JointMove::takeBackAtTurnedFaces(const std::vector<Index>& sideFaces)
{
  bool any = false;
  for (const Index b : sideFaces)
  {
    const auto v = mesh_.boundaryVertices(b);
    if (isConcerned(v) && isTurned(b))
    {
      std::for_each(v.begin(), v.end(), [this](Index w) { takeBack(w); });
      any = true;
    }
  }
  return any;
}

bool JointMove::isTurned(Index sideFace) const
{
  const auto v = mesh_.boundaryVertices(sideFace);
  return !turns_.allows(turns_.faithfulness(sideFace),
    turns_.faithfulness(mesh_.boundaryFace(sideFace).patch, v, { before(v[0]), before(v[1]), before(v[2]) }));
}

bool JointMove::takeBackAtSpoiledTets(const std::vector<Index>& tets)
{
  bool any = false;
  for (const Index t : tets)
  {
    const auto& vertices = mesh_.tet(t).vertex;
    if (isConcerned(vertices) && isSpoiled(vertices))
    {
      std::for_each(vertices.begin(), vertices.end(), [this](Index v) { takeBack(v); });
      any = true;
    }
  }
  return any;
}

bool JointMove::isSpoiled(const std::array<Index, 4>& v) const
{
  const double now = quality(mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]), mesh_.point(v[3]));
  if (now > FrontMoves::GoodQuality)
  {
    return false;
  }
  return !(now > 0) ||
    now < FrontMoves::QualityKept * quality(before(v[0]), before(v[1]), before(v[2]), before(v[3]));
}

Vector3 JointMove::before(Index vertex) const
{
  return hasMoved(vertex) ? oldPosition_[set_.ofVertex[vertex]] : mesh_.point(vertex);
}

void JointMove::takeBack(Index vertex)
{
  if (hasMoved(vertex))
  {
    const Index column = set_.ofVertex[vertex];
    moved_[vertex] = 0;
    lastChange_[vertex] = round_;
    front_.setShare(column, oldShare_[column]);
    mesh_.movePoint(vertex, oldPosition_[column]);
  }
}
} // namespace ransmesh

#include "Insertion/JointMove.h"

#include "Geometry/TetrahedronMeasures.h"
#include "Insertion/FrontMoves.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
// The walk around a vertex takes as long as a look at so many tetrahedra in their order.
constexpr std::size_t TetsPerWalk = 64;
} // namespace

std::size_t JointMove::run(const std::vector<double>& target)
{
  place(target);
  collectWork();
  // What is taken back changes its neighbours' tetrahedra: again, until all are well. In the worst case
  // every top is back where it was.
  for (bool again = true; again;)
  {
    const bool folded = takeBackAtFoldedFaces();
    const bool spoiled = takeBackAtSpoiledTets();
    const bool turned = takeBackAtTurnedFaces();
    again = folded || spoiled || turned;
  }
  return static_cast<std::size_t>(std::count_if(movedColumns_.begin(), movedColumns_.end(),
    [this](Index c) { return hasMoved(set_.columns[c].vertex); }));
}

void JointMove::place(const std::vector<double>& target)
{
  const std::size_t count = set_.columns.size();
  moved_.assign(mesh_.vertexCount(), 0);
  movedColumns_.clear();
  oldShare_.resize(count);
  oldPosition_.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto c = static_cast<Index>(i);
    const Index vertex = set_.columns[i].vertex;
    if (target[i] > front_.share(c))
    {
      oldShare_[i] = front_.share(c);
      oldPosition_[i] = mesh_.point(vertex);
      moved_[vertex] = 1;
      movedColumns_.push_back(c);
      front_.setShare(c, target[i]);
      mesh_.movePoint(vertex, front_.position(c, target[i]));
    }
  }
}

bool JointMove::anyHasMoved(std::span<const Index> vertices) const
{
  int moved = 0; // without branches: whether a vertex moved is a toss
  for (const Index v : vertices)
  {
    moved |= moved_[v];
  }
  return moved != 0;
}

void JointMove::collectWork()
{
  faces_.clear(front_.faces().size());
  for (const Index c : movedColumns_)
  {
    for (const Index face : front_.facesAt(c))
    {
      faces_.add(static_cast<std::size_t>(face));
    }
  }
  collectTets();
  collectSideFaces();
}

void JointMove::collectTets()
{
  tets_.clear(mesh_.tetSlots());
  if (movedColumns_.size() * TetsPerWalk < mesh_.tetSlots())
  {
    for (const Index c : movedColumns_)
    {
      traversal_.ball(set_.columns[c].vertex, ball_);
      for (const Index t : ball_)
      {
        tets_.add(static_cast<std::size_t>(t));
      }
    }
    return;
  }
  for (std::size_t t = 0; t < mesh_.tetSlots(); ++t)
  {
    const Tetrahedron& tet = mesh_.tet(static_cast<Index>(t));
    if (tet.isAlive() && anyHasMoved(tet.vertex))
    {
      tets_.add(t);
    }
  }
}

void JointMove::collectSideFaces()
{
  sideFaces_.clear(mesh_.boundarySlots());
  for (std::size_t i = 0; turns_.anyCurved() && i < mesh_.boundarySlots(); ++i)
  {
    const auto b = static_cast<Index>(i);
    if (mesh_.boundaryFace(b).isAlive() && turns_.isCurved(mesh_.boundaryFace(b).patch) &&
      anyHasMoved(mesh_.boundaryVertices(b)))
    {
      sideFaces_.add(i);
    }
  }
}

bool JointMove::takeBackAtFoldedFaces()
{
  bool any = false;
  faces_.runRound(
    [&](std::size_t i)
    {
      const BaseFace& face = front_.faces()[i];
      if (anyHasMoved(face.vertex) && !front_.slabIsPositive(i))
      {
        takeBackAll(face.vertex);
        any = true;
      }
    });
  return any;
}

bool JointMove::takeBackAtSpoiledTets()
{
  bool any = false;
  tets_.runRound(
    [&](std::size_t t)
    {
      const auto& vertices = mesh_.tet(static_cast<Index>(t)).vertex;
      if (anyHasMoved(vertices) && isSpoiled(vertices))
      {
        takeBackAll(vertices);
        any = true;
      }
    });
  return any;
}

bool JointMove::takeBackAtTurnedFaces()
{
  bool any = false;
  sideFaces_.runRound(
    [&](std::size_t i)
    {
      const auto b = static_cast<Index>(i);
      const auto vertices = mesh_.boundaryVertices(b);
      if (anyHasMoved(vertices) && isTurned(b))
      {
        takeBackAll(vertices);
        any = true;
      }
    });
  return any;
}

bool JointMove::isTurned(Index sideFace) const
{
  const auto v = mesh_.boundaryVertices(sideFace);
  return !turns_.allows(turns_.faithfulness(sideFace),
    turns_.faithfulness(mesh_.boundaryFace(sideFace).patch, v, { before(v[0]), before(v[1]), before(v[2]) }));
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

void JointMove::takeBackAll(std::span<const Index> vertices)
{
  for (const Index v : vertices)
  {
    if (hasMoved(v))
    {
      takeBack(v);
    }
  }
}

void JointMove::takeBack(Index vertex)
{
  const Index column = set_.ofVertex[vertex];
  moved_[vertex] = 0;
  front_.setShare(column, oldShare_[column]);
  mesh_.movePoint(vertex, oldPosition_[column]);
  for (const Index face : front_.facesAt(column))
  {
    faces_.addAgain(static_cast<std::size_t>(face));
  }
  traversal_.ball(vertex, ball_);
  for (const Index t : ball_)
  {
    tets_.addAgain(static_cast<std::size_t>(t));
    for (const HalfFace beyond : mesh_.tet(t).neighbour)
    {
      if (isBoundary(beyond) && turns_.isCurved(mesh_.patchOf(beyond)))
      {
        sideFaces_.addAgain(static_cast<std::size_t>(boundaryFaceOf(beyond)));
      }
    }
  }
}
} // namespace ransmesh

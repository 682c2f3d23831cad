#include "Insertion/FrontCrossings.h"

#include "Geometry/Predicates.h"

#include <algorithm>
#include <limits>

namespace ransmesh
{
namespace
{
struct Box
{
  void add(const Vector3& x)
  {
    low = { std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z) };
    high = { std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z) };
  }
  bool meets(const Box& other) const
  {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y &&
      low.z <= other.high.z && other.low.z <= high.z;
  }

  static constexpr double Beyond = std::numeric_limits<double>::infinity();
  Vector3 low{ Beyond, Beyond, Beyond };
  Vector3 high{ -Beyond, -Beyond, -Beyond };
};

using Corners = std::array<Vector3, 3>;

bool passesThrough(const Vector3& p, const Vector3& q, const Corners& t)
{
  if (orientation(t[0], t[1], t[2], p) * orientation(t[0], t[1], t[2], q) >= 0)
  {
    return false;
  }
  const int side = orientation(p, q, t[0], t[1]);
  return side != 0 && orientation(p, q, t[1], t[2]) == side && orientation(p, q, t[2], t[0]) == side;
}

bool cross(const Corners& s, const Corners& t)
{
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    if (passesThrough(s[i], s[j], t) || passesThrough(t[i], t[j], s))
    {
      return true;
    }
  }
  return false;
}

template <class Visit>
void forEachBoundaryTriangle(const TetMesh& mesh, Visit visit)
{
  for (std::size_t i = 0; i < mesh.boundarySlots(); ++i)
  {
    const auto b = static_cast<Index>(i);
    if (mesh.boundaryFace(b).isAlive())
    {
      visit(mesh.boundaryVertices(b));
    }
  }
}
} // namespace

FrontCrossings::FrontCrossings(const TetMesh& mesh, const ColumnSet& set, const std::vector<Index>& columns)
  : mesh_(mesh)
  , set_(set)
{
  std::vector<Index> number(set.columns.size(), None); // in boxes
  std::vector<Box> boxes;
  for (const Index c : columns)
  {
    number[c] = static_cast<Index>(boxes.size());
    boxes.emplace_back();
    boxes.back().add(set.pointAt(set.columns[c], set.columns[c].levels));
  }
  forEachBoundaryTriangle(mesh,
    [&](const Triangle& t)
    {
      for (const Index v : t)
      {
        const Index c = set.ofVertex[v];
        if (c != None && number[c] != None)
        {
          around_[c].own.push_back(t);
          std::for_each(t.begin(), t.end(), [&](Index w) { boxes[number[c]].add(mesh.point(w)); });
        }
      }
    });
  Box all;
  for (const Box& box : boxes)
  {
    all.add(box.low);
    all.add(box.high);
  }
  forEachBoundaryTriangle(mesh,
    [&](const Triangle& t)
    {
      Box box;
      std::for_each(t.begin(), t.end(), [&](Index v) { box.add(mesh.point(v)); });
      for (std::size_t i = 0; all.meets(box) && i < boxes.size(); ++i)
      {
        if (boxes[i].meets(box))
        {
          around_[columns[i]].near.push_back(t);
        }
      }
    });
}

bool FrontCrossings::wouldCross(Index column, const Vector3& x) const
{
  const Index top = set_.columns[column].vertex;
  const auto corners = [&](const Triangle& t)
  {
    const auto place = [&](Index v) { return v == top ? x : mesh_.point(v); };
    return Corners{ place(t[0]), place(t[1]), place(t[2]) };
  };
  const Surroundings& around = around_.at(column);
  return std::any_of(around.own.begin(), around.own.end(),
    [&](const Triangle& own)
    {
      return std::any_of(around.near.begin(), around.near.end(),
        [&](const Triangle& other)
        { return !haveCommonRoot(own, other) && cross(corners(own), corners(other)); });
    });
}

bool FrontCrossings::haveCommonRoot(const Triangle& a, const Triangle& b) const
{
  return std::any_of(a.begin(), a.end(),
    [&](Index v)
    { return std::any_of(b.begin(), b.end(), [&](Index w) { return set_.rootOf(v) == set_.rootOf(w); }); });
}
} // namespace ransmesh

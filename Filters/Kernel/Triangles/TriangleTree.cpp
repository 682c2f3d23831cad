#include "Triangles/TriangleTree.h"

#include "Geometry/Distance.h"

#include <algorithm>

namespace ransmesh
{
TriangleTree::TriangleTree(const SurfaceMesh& surface, std::vector<Index> triangles)
  : surface_(surface)
  , triangles_(std::move(triangles))
{
  if (triangles_.empty())
  {
    return;
  }
  std::vector<Placed> placed;
  placed.reserve(triangles_.size());
  for (const Index t : triangles_)
  {
    placed.push_back({ centreOf(surface, t), t });
  }
  nodes_.reserve(triangles_.size());
  build(placed, 0);
  for (std::size_t i = 0; i < placed.size(); ++i)
  {
    triangles_[i] = placed[i].triangle;
  }
}

Extent TriangleTree::around(std::span<const Placed> placed) const
{
  const Vector3& first = surface_.points[surface_.triangles[placed.front().triangle][0]];
  Extent box{ first, first };
  for (const Placed& p : placed)
  {
    for (const Index v : surface_.triangles[p.triangle])
    {
      box.add(surface_.points[v]);
    }
  }
  return box;
}

Index TriangleTree::build(std::span<Placed> placed, Index begin)
{
  const auto number = static_cast<Index>(nodes_.size());
  const auto count = static_cast<Index>(placed.size());
  nodes_.push_back({ around(placed), begin, begin + count, None });
  constexpr Index leafSize = 4;
  if (count > leafSize)
  {
    const int axis = nodes_[number].box.longestAxis();
    const Index half = count / 2;
    std::nth_element(placed.begin(), placed.begin() + half, placed.end(),
      [axis](const Placed& s, const Placed& t) { return s.centre[axis] < t.centre[axis]; });
    build(placed.first(half), begin);
    nodes_[number].right = build(placed.subspan(half), begin + half);
  }
  return number;
}

void TriangleTree::search(Index node, const Vector3& p, Nearest& nearest) const
{
  const Node& here = nodes_[node];
  if (here.right == None)
  {
    for (Index i = here.begin; i < here.end; ++i)
    {
      const auto& t = surface_.triangles[triangles_[i]];
      const Vector3 q =
        closestPointOnTriangle(p, surface_.points[t[0]], surface_.points[t[1]], surface_.points[t[2]]);
      const double square = dot(q - p, q - p);
      if (square < nearest.square)
      {
        nearest = { square, q, triangles_[i] };
      }
    }
    return;
  }
  Index near = node + 1;
  Index far = here.right;
  double squareNear = nodes_[near].box.squareTo(p);
  double squareFar = nodes_[far].box.squareTo(p);
  if (squareFar < squareNear)
  {
    std::swap(near, far);
    std::swap(squareNear, squareFar);
  }
  if (squareNear < nearest.square)
  {
    search(near, p, nearest);
  }
  if (squareFar < nearest.square)
  {
    search(far, p, nearest);
  }
}

Index TriangleTree::closest(Vector3& p) const
{
  Nearest nearest;
  if (!nodes_.empty())
  {
    search(0, p, nearest);
    p = nearest.triangle == None ? p : nearest.place;
  }
  return nearest.triangle;
}
} // namespace ransmesh

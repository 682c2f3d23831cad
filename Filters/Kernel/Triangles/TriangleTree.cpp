#include "Triangles/TriangleTree.h"

#include "Geometry/Distance.h"

#include <algorithm>

namespace ransmesh
{
TriangleTree::TriangleTree(const SurfaceMesh& surface, std::vector<Index> triangles)
  : surface_(surface)
  , triangles_(std::move(triangles))
{
  if (!triangles_.empty())
  {
    build(0, static_cast<Index>(triangles_.size()));
  }
}

TriangleTree::Node TriangleTree::around(Index begin, Index end) const
{
  const Vector3& first = surface_.points[surface_.triangles[triangles_[begin]][0]];
  Node node{ first, first, begin, end, None };
  for (Index i = begin; i < end; ++i)
  {
    for (const Index v : surface_.triangles[triangles_[i]])
    {
      for (int k = 0; k < 3; ++k)
      {
        node.low[k] = std::min(node.low[k], surface_.points[v][k]);
        node.high[k] = std::max(node.high[k], surface_.points[v][k]);
      }
    }
  }
  return node;
}

Index TriangleTree::build(Index begin, Index end)
{
  const auto number = static_cast<Index>(nodes_.size());
  nodes_.push_back(around(begin, end));
  constexpr Index leafSize = 4;
  if (end - begin > leafSize)
  {
    const Vector3 extent = nodes_[number].high - nodes_[number].low;
    const int axis = extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
    const Index middle = begin + (end - begin) / 2;
    std::nth_element(triangles_.begin() + begin, triangles_.begin() + middle, triangles_.begin() + end,
      [&](Index s, Index t) { return centreOf(surface_, s)[axis] < centreOf(surface_, t)[axis]; });
    build(begin, middle);
    nodes_[number].right = build(middle, end);
  }
  return number;
}

double TriangleTree::squareTo(Index node, const Vector3& p) const
{
  double square = 0;
  for (int k = 0; k < 3; ++k)
  {
    const double off = std::max({ nodes_[node].low[k] - p[k], 0.0, p[k] - nodes_[node].high[k] });
    square += off * off;
  }
  return square;
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
  double squareNear = squareTo(near, p);
  double squareFar = squareTo(far, p);
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

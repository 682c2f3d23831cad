// Which triangle of a set is closest to a place.
#pragma once

#include "Triangles/SurfaceMesh.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace ransmesh
{
// A tree of boxes around triangles, of which the nearer is looked at first. (CGAL's starts from the nearest
// corner, which for needles is far away: a hundred times slower there.)
class TriangleTree
{
public:
  // The surface must live as long as this.
  TriangleTree(const SurfaceMesh& surface, std::vector<Index> triangles);

  // The triangle closest to p, which moves to the closest place on it; None if there are none.
  Index closest(Vector3& p) const;

  // Calls visit(triangle) for those in boxes that a ball reaches: its centre and radius are asked for anew, and may
  // shrink, whenever a box is looked at. Boxes nearer to its centre come first.
  template <typename BallOf, typename Visit>
  void visitWithin(const BallOf& ballOf, const Visit& visit) const
  {
    if (!nodes_.empty())
    {
      visitBelow(0, ballOf, visit);
    }
  }

private:
  struct Node
  {
    Vector3 low;
    Vector3 high;
    Index begin = 0;
    Index end = 0;
    Index right = None; // the left child follows its parent; None: a leaf
  };
  struct Nearest
  {
    double square = INFINITY;
    Vector3 place;
    Index triangle = None;
  };

  template <typename BallOf, typename Visit>
  void visitBelow(Index node, const BallOf& ballOf, const Visit& visit) const
  {
    const Node& here = nodes_[node];
    if (here.right == None)
    {
      std::for_each(triangles_.begin() + here.begin, triangles_.begin() + here.end, visit);
      return;
    }
    const auto [centre, radius] = ballOf();
    std::pair near(squareTo(node + 1, centre), node + 1);
    std::pair far(squareTo(here.right, centre), here.right);
    if (far.first < near.first)
    {
      std::swap(near, far);
    }
    if (near.first < radius * radius)
    {
      visitBelow(near.second, ballOf, visit);
    }
    const auto [centreNow, radiusNow] = ballOf();
    if (radiusNow != radius)
    {
      far.first = squareTo(far.second, centreNow);
    }
    if (far.first < radiusNow * radiusNow)
    {
      visitBelow(far.second, ballOf, visit);
    }
  }

  Index build(Index begin, Index end);
  Node around(Index begin, Index end) const;
  void search(Index node, const Vector3& p, Nearest& nearest) const;
  double squareTo(Index node, const Vector3& p) const;

  const SurfaceMesh& surface_;
  std::vector<Index> triangles_; // in the order of the leaves
  std::vector<Node> nodes_;
};
} // namespace ransmesh

// Which triangle of a set is closest to a place.
#pragma once

#include "Triangles/SurfaceMesh.h"

#include <span>
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

  Index build(Index begin, Index end);
  Node around(Index begin, Index end) const;
  void search(Index node, const Vector3& p, Nearest& nearest) const;
  double squareTo(Index node, const Vector3& p) const;

  const SurfaceMesh& surface_;
  std::vector<Index> triangles_; // in the order of the leaves
  std::vector<Node> nodes_;
};
} // namespace ransmesh

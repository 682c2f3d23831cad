// Which triangle of a set is closest to a place.
#pragma once

#include "Triangles/SurfaceMesh.h"

#include <algorithm>
#include <span>
#include <vector>

namespace ransmesh
{
struct Ball
{
  Vector3 centre;
  double square = 0; // of the radius
};

// A tree of boxes around triangles, of which the nearer is looked at first. (CGAL's starts from the nearest
// corner, which for needles is far away: a hundred times slower there.)
class TriangleTree
{
public:
  // The surface must live as long as this.
  TriangleTree(const SurfaceMesh& surface, std::vector<Index> triangles);

  // The triangle closest to p, which moves to the closest place on it; None if there are none.
  Index closest(Vector3& p) const;

  // Calls visit(place in inOrder) for the triangles in boxes that a ball reaches, which may shrink meanwhile. Boxes
  // nearer to its centre come first.
  template <typename Visit>
  void visitWithin(const Ball& ball, const Visit& visit) const
  {
    if (!nodes_.empty())
    {
      visitBelow(0, ball, visit);
    }
  }
  // Calls visit(triangle) for those in leaves whose boxes meet this one.
  template <typename Visit>
  void visitMeeting(const Extent& box, const Visit& visit) const
  {
    if (!nodes_.empty())
    {
      visitMeetingBelow(0, box, visit);
    }
  }
  // All triangles, those of one leaf after each other.
  const std::vector<Index>& inOrder() const { return triangles_; }

private:
  struct Node
  {
    Extent box;
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

  struct Placed
  {
    Vector3 centre;
    Index triangle;
  };

  template <typename Visit>
  void visitBelow(Index node, const Ball& ball, const Visit& visit) const
  {
    const Node& here = nodes_[node];
    if (here.right == None)
    {
      for (Index place = here.begin; place < here.end; ++place)
      {
        visit(place);
      }
      return;
    }
    const double left = nodes_[node + 1].box.squareTo(ball.centre);
    const double right = nodes_[here.right].box.squareTo(ball.centre);
    const Index near = right < left ? here.right : node + 1;
    const Index far = right < left ? node + 1 : here.right;
    const double square = ball.square;
    if (std::min(left, right) < square)
    {
      visitBelow(near, ball, visit);
    }
    const bool isAsBefore = ball.square == square;
    if ((isAsBefore ? std::max(left, right) : nodes_[far].box.squareTo(ball.centre)) < ball.square)
    {
      visitBelow(far, ball, visit);
    }
  }

  template <typename Visit>
  void visitMeetingBelow(Index node, const Extent& box, const Visit& visit) const
  {
    const Node& here = nodes_[node];
    if (!here.box.meets(box))
    {
      return;
    }
    if (here.right == None)
    {
      std::for_each(triangles_.begin() + here.begin, triangles_.begin() + here.end, visit);
      return;
    }
    visitMeetingBelow(node + 1, box, visit);
    visitMeetingBelow(here.right, box, visit);
  }

  Index build(std::span<Placed> placed, Index begin);
  Extent around(std::span<const Placed> placed) const;
  void search(Index node, const Vector3& p, Nearest& nearest) const;

  const SurfaceMesh& surface_;
  std::vector<Index> triangles_; // in the order of the leaves
  std::vector<Node> nodes_;
};
} // namespace ransmesh

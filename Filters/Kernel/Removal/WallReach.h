// How far the layers reach above the walls' triangles.
#pragma once

#include "Layers/LayerSpecification.h"
#include "Mesh/TetMesh.h"

#include <cmath>
#include <span>
#include <vector>

namespace ransmesh
{
// The thickness of the layers where the local isotropic size is the one given: no level counts whose
// spacing exceeds isotropicFraction * size (section 3 of Loehner's paper).
double limitedThickness(const LayerHeights& heights, double isotropicFraction, double size);

// The walls' triangles, those at each vertex, and how far the region of the layers, with a margin in lengths of the
// triangles' edges, reaches from each.
class WallReach
{
public:
  // A plane over a vertex of a wall: above it nothing is within reach of the triangles there.
  struct Ceiling
  {
    bool isBelow(const Vector3& p) const { return dot(p, normal) > height; }

    Vector3 normal;
    double height = 0;
  };

  WallReach(const TetMesh& mesh, const LayerPlan& plan, double margin);

  bool isWall(Index v) const { return isWall_[v] != 0; }
  // Has the tetrahedron vertices of walls and others? Without branches: whether one is of a wall is a toss.
  bool isAtWall(const Tetrahedron& tet) const
  {
    int ofWalls = 0;
    for (const Index v : tet.vertex)
    {
      ofWalls += isWall_[v];
    }
    return ofWalls != 0 && ofWalls != 4;
  }
  // The triangles at a vertex of the walls.
  std::span<const Index> at(Index v) const
  {
    return { triangleAt_.data() + first_[v], triangleAt_.data() + first_[v + 1] };
  }
  const Ceiling& ceilingOver(Index v) const { return ceiling_[v]; }
  double reach(Index t) const { return bounds_[t].reach; }

  // The quality of the tetrahedron from triangle t to the end of its reach.
  double attainableQuality(Index t) const;

  // Whether p lies within the reach of triangle t.
  bool reaches(const Vector3& p, Index t) const
  {
    const Bounds& bounds = bounds_[t];
    const Vector3 offset = p - bounds.centre;
    return std::fabs(dot(offset, bounds.normal)) <= bounds.reach &&
      dot(offset, offset) <= bounds.radius * bounds.radius && isNear(p, t);
  }

  // Walks over the wall from triangle t to one whose centre is closer to p than those around it.
  Index approach(const Vector3& p, Index t) const;

  // A triangle that reaches p: t or one around it; None if none does.
  Index reachingAround(const Vector3& p, Index t) const;

private:
  struct WallTriangle
  {
    std::array<Index, 3> vertex;
    int patch;
    double perimeter;
  };

  // For quick bounds, all in one line of the cache: a sphere that holds a triangle, grown by the triangle's reach, and
  // its plane.
  struct alignas(64) Bounds
  {
    Vector3 centre;
    double radius;
    Vector3 normal; // unit, or zero
    double reach;
  };

  bool isNear(const Vector3& p, Index t) const;
  void collect(const LayerPlan& plan);
  double addBounds(const std::array<Index, 3>& v);
  void linkToVertices();
  double sizeAt(Index v) const;
  void findReaches(const LayerPlan& plan, double margin);
  void findCeilings();
  Ceiling findCeiling(Index v) const;

  const TetMesh& mesh_;
  std::vector<WallTriangle> triangles_;
  std::vector<Bounds> bounds_; // of triangles_
  std::vector<Index> first_;   // by vertex: its triangles are triangleAt_[first_[v]] up to first_[v + 1]
  std::vector<Index> triangleAt_;
  std::vector<Ceiling> ceiling_; // by vertex
  std::vector<char> isWall_;     // by vertex; small, so that it stays in the cache
};
} // namespace ransmesh

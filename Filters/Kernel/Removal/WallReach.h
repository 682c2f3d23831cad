// How far the layers reach above the walls' triangles.
#pragma once

#include "Boundary/BoundaryStars.h"
#include "Layers/LayerSpecification.h"
#include "Mesh/TetMesh.h"
#include "Support/Prefetch.h"

#include <cmath>
#include <limits>
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
    double height = -std::numeric_limits<double>::infinity();
  };

  WallReach(const TetMesh& mesh, const BoundaryStars& stars, const LayerPlan& plan, double margin);

  bool isWall(Index v) const { return wallNumber_[v] != None; }
  // The boundary faces at a vertex of the walls: those without layers reach nothing, and are near to nothing.
  std::span<const Index> at(Index v) const { return stars_.facesAt(v); }
  const Ceiling& ceilingOver(Index v) const { return walls_[wallNumber_[v]].ceiling; }
  // For those who will ask for the ceiling over a wall's vertex soon, and very soon.
  void fetchAhead(Index v) const { prefetch(&wallNumber_[v]); }
  void fetchCeilingAhead(Index v) const { prefetch(&walls_[wallNumber_[v]]); }
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

  // Whether p lies over the plane of triangle t by more than its reach, by far.
  bool isFarOver(const Vector3& p, Index t) const
  {
    constexpr double far = 1.25;
    return std::fabs(dot(p - bounds_[t].centre, bounds_[t].normal)) > far * bounds_[t].reach;
  }

  // Whether the centre of triangle t is nearer to p than that of the other one.
  bool isNearer(const Vector3& p, Index t, Index other) const
  {
    const Vector3 to = p - bounds_[t].centre;
    const Vector3 toOther = p - bounds_[other].centre;
    return dot(to, to) < dot(toOther, toOther);
  }

  // Walks over the wall from triangle t to one whose centre is closer to p than those around it.
  Index approach(const Vector3& p, Index t) const;

  // A triangle that reaches p: t or one around it; None if none does.
  Index reachingAround(const Vector3& p, Index t) const;

private:
  static constexpr double Nowhere = std::numeric_limits<double>::infinity();

  // For quick bounds, all in one line of the cache: a sphere that holds a triangle, grown by the triangle's reach, and
  // its plane. Where there are no layers, nowhere.
  struct alignas(64) Bounds
  {
    Vector3 centre{ Nowhere, Nowhere, Nowhere };
    double radius = -1;
    Vector3 normal; // unit, or zero
    double reach = -1;
  };

  // A vertex of the walls.
  struct Wall
  {
    Ceiling ceiling;
    double size = 0; // the mean edge of the walls' triangles there
    int triangles = 0;
  };

  bool isLayered(Index face) const { return bounds_[face].radius >= 0; }
  bool isNear(const Vector3& p, Index t) const;
  void collect(const LayerPlan& plan);
  void addBounds(Index face);
  double sizeAt(Index v) const { return walls_[wallNumber_[v]].size; }
  void findReaches(const LayerPlan& plan, double margin);
  void raiseCeilings();

  const TetMesh& mesh_;
  const BoundaryStars& stars_;
  std::vector<Bounds> bounds_;    // by boundary face; those without layers have a negative radius
  std::vector<Index> wallNumber_; // by vertex: its number among those of walls, or None
  std::vector<Wall> walls_;       // by that number
};
} // namespace ransmesh

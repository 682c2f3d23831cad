// Swaps and movement: better tetrahedra from the same points.
#pragma once

#include "Boundary/BoundaryRules.h"
#include "Geometry/TetrahedronMeasures.h"
#include "Improvement/EdgeMemory.h"
#include "Improvement/ShapeMemory.h"
#include "Mesh/Star.h"
#include "Mesh/Traversal.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ransmesh
{
// The quality (Geometry/TetrahedronMeasures.h) of a live tetrahedron of the mesh.
inline double qualityOf(const TetMesh& mesh, Index t)
{
  const auto& v = mesh.tet(t).vertex;
  return quality(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3]));
}

// When what changed, as counts of changes, from 1: a swap that failed is worth another try only where something has
// changed.
struct SwapMemory
{
  unsigned corners = 0b1111; // those with changes since (bit i for corner i)
  const std::vector<std::uint32_t>* changedAt =
    nullptr;                 // by tetrahedron; all count as changed where there is none
  std::uint32_t triedAt = 0; // 0: never
  std::uint32_t now = 0;

  bool anyHasChanged(std::span<const Index> tets, std::uint32_t since) const
  {
    return !changedAt ||
      std::any_of(tets.begin(), tets.end(), [&](Index t) { return (*changedAt)[t] > since; });
  }
};

class LocalImprovement
{
public:
  // Edges with more than largestRing tetrahedra around them are not swapped away.
  LocalImprovement(TetMesh& mesh, const BoundaryRules& rules, ShapeMeasure measure = plainQuality,
    std::size_t largestRing = 9)
    : mesh_(mesh)
    , rules_(rules)
    , measure_(measure)
    , largestRing_(largestRing)
    , star_(mesh)
    , traversal_(mesh)
  {
  }

  // Tries to replace the tetrahedron by better ones: by taking out one of its edges inside the mesh, or
  // one of its faces. The worst quality among those that change must rise.
  // Only edges and faces between the memory's corners are tried, and of these only those with a tetrahedron that
  // has changed.
  bool swap(Index tet, const SwapMemory& memory = {});

  // Moves a vertex of the volume towards the mean of its neighbours if that does not make the worst
  // quality around it less than keep times what it was.
  bool move(Index v, double keep);

  // Moves a vertex of the volume towards a place, as far as the qualities around it stay above floor, or
  // above what they were where that is less.
  bool moveTowards(Index v, const Vector3& place, double floor);

  // The measure of one tetrahedron, or anything above ceiling if it is above that.
  double shapeOf(Index tet, double ceiling);
  // To be called before the next swap or move when others have changed the mesh.
  void noteChanges() { shapes_.forgetAll(); }

  // The tetrahedra made by the last successful swap.
  const std::vector<Index>& made() const { return *made_; }
  // Those at the vertex that was moved last.
  const std::vector<Index>& around() const { return tets_; }

private:
  bool swapEdge(Index tet, int edge, const SwapMemory& memory);
  bool swapFace(Index tet, int face, const SwapMemory& memory);
  bool walkAround(Index tet, Index a, Index b);
  double worstWithout(Index a, Index b, std::size_t apex, double floor) const;
  double worstWith(Index d, Index e, const std::array<Index, 3>& face, double floor) const;
  bool star(Index apex);
  // As ShapeMeasure.
  double shapeOf(const std::array<Index, 4>& v, const ShapeRange& range) const
  {
    return measure_(mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]), mesh_.point(v[3]), range);
  }
  double worstOf(std::span<const Index> tets);
  double worstFirst(std::vector<Index>& tets);
  void forgetShapes(std::span<const Index> tets);
  Vector3 meanNeighbour(Index v) const;
  bool moveOnto(Index v, const Vector3& place, double wanted);
  bool allAbove(double wanted);
  bool allPositive() const;

  TetMesh& mesh_;
  const BoundaryRules& rules_;
  ShapeMeasure measure_;
  std::size_t largestRing_;
  Star star_;
  Traversal traversal_;
  ShapeMemory shapes_;
  EdgeMemory edges_;
  Cavity cavity_;
  std::vector<Index> tets_;
  std::vector<Index> ring_; // vertices around an edge
  const std::vector<Index>* made_ = nullptr;
};
} // namespace ransmesh

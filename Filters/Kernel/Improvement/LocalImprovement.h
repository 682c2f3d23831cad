// Swaps and movement: better tetrahedra from the same points.
#pragma once

#include "Improvement/GrowingCavity.h"
#include "Mesh/Star.h"
#include "Mesh/Traversal.h"

#include <vector>

namespace ransmesh
{
class LocalImprovement
{
public:
  LocalImprovement(TetMesh& mesh, const BoundaryRules& rules, ShapeMeasure measure = quality)
    : mesh_(mesh)
    , rules_(rules)
    , measure_(measure)
    , star_(mesh)
    , traversal_(mesh)
    , cavity_(mesh, rules, measure)
  {
  }

  // Tries to replace the tetrahedron by better ones: by taking out one of its edges inside the mesh, or
  // one of its faces. The worst quality among those that change must rise.
  bool swap(Index tet);

  // Moves a vertex of the volume towards the mean of its neighbours if that does not make the worst
  // quality around it less than keep times what it was.
  bool move(Index v, double keep);

  // Moves a vertex of the volume towards a place, as far as the qualities around it stay above floor, or
  // above what they were where that is less.
  bool moveTowards(Index v, const Vector3& place, double floor);

  // The measure of one tetrahedron.
  double shapeOf(Index tet) const;

  // The tetrahedra made by the last successful swap.
  const std::vector<Index>& made() const { return *made_; }

private:
  bool swapEdge(Index tet, int edge);
  bool swapFace(Index tet, int face);
  bool starBest(std::span<const Index> tets, std::span<const Index> apexes);
  bool ringIsClosed(Index a, Index b) const;
  double worstOf(std::span<const Index> tets) const;
  Vector3 meanNeighbour(Index v) const;
  bool moveOnto(Index v, const Vector3& place, double wanted);

  TetMesh& mesh_;
  const BoundaryRules& rules_;
  ShapeMeasure measure_;
  Star star_;
  Traversal traversal_;
  GrowingCavity cavity_;
  std::vector<Index> tets_;
  std::vector<Index> apexes_;
  const std::vector<Index>* made_ = nullptr;
};
} // namespace ransmesh

// What starring boundary faces again does to the surface.
#pragma once

#include "Boundary/BoundaryRules.h"
#include "Boundary/EdgeUses.h"
#include "Mesh/Traversal.h"
#include "Removal/RemovalVerdict.h"
#include "Removal/SurfaceMemory.h"

#include <array>
#include <span>
#include <vector>

namespace ransmesh
{
class SurfaceStar
{
public:
  // cosine: of the largest angle by which a boundary face may turn. memory: of this surface.
  SurfaceStar(const TetMesh& mesh, const BoundaryRules& rules, double cosine, SurfaceMemory& memory)
    : mesh_(mesh)
    , rules_(rules)
    , cosine_(cosine)
    , memory_(memory)
    , traversal_(mesh)
  {
  }

  // May these boundary faces be replaced by triangles from their rim to the apex? Of the ridge edges
  // between them only those at the vertex vanishing (None: no vertex) may go.
  // Collapsed: they may. RidgeLost, SurfaceTurned: why not.
  RemovalVerdict judge(std::span<const Index> faces, Index apex, Index vanishing);

  // The same faces of a wall, just judged: may they, as far as the shape of the triangles goes? Their
  // largest angle (degrees) must not exceed the one given, unless it was as large before; they may not
  // lie too far from the wall's normal (zero: where it has none).
  // Collapsed: they may. PoorTriangle, SurfaceTurned: why not.
  RemovalVerdict judgeShape(
    std::span<const Index> faces, Index apex, const Vector3& normal, double angle) const;

  // The faces that were judged last have been replaced.
  void remember() { memory_.remember(); }

private:
  bool turnsTooFar(const EdgeUse& rim, Index apex) const;
  RemovalVerdict judgeEdges(Index apex, Index vanishing);
  bool meetsSurfaceAgain(std::span<const Index> faces, Index apex);
  bool staysInPlace(std::span<const Index> faces, Index apex);

  const TetMesh& mesh_;
  const BoundaryRules& rules_;
  double cosine_;
  SurfaceMemory& memory_;
  Traversal traversal_;
  std::vector<EdgeUse> edges_;
  std::vector<std::array<Index, 2>> inner_;    // edges that go
  std::vector<std::array<Index, 2>> newBases_; // edges of the rim that get a triangle
  std::vector<Index> newEnds_;                 // vertices that new edges join to the apex
  std::vector<Index> rimAtApex_;               // vertices that edges of the rim join to it already
  std::vector<Index> ball_;
  std::vector<SurfaceMemory::Piece> old_;
  std::vector<SurfaceMemory::Piece> new_;
  std::vector<Vector3> lost_;
};
} // namespace ransmesh

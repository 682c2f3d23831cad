// What starring boundary faces again does to the surface.
#pragma once

#include "Boundary/Classification.h"
#include "Mesh/Traversal.h"
#include "Removal/RemovalVerdict.h"

#include <array>
#include <span>
#include <vector>

namespace ransmesh
{
class SurfaceStar
{
public:
  // cosine: of the largest angle by which a boundary face may turn.
  SurfaceStar(const TetMesh& mesh, const Ridges& ridges, double cosine)
    : mesh_(mesh)
    , ridges_(ridges)
    , cosine_(cosine)
    , traversal_(mesh)
  {
  }

  // May these boundary faces be replaced by triangles from their rim to the apex? Of the ridge edges
  // between them only those at the vertex vanishing (None: no vertex) may go.
  // Collapsed: they may. RidgeLost, SurfaceTurned: why not.
  RemovalVerdict judge(std::span<const Index> faces, Index apex, Index vanishing);

private:
  struct EdgeUse
  {
    Index low;
    Index high;
    std::array<Index, 2> way; // as the face, turned inward, has it
    Index face;
  };

  void collectEdges(std::span<const Index> faces);
  bool turnsTooFar(const EdgeUse& rim, Index apex) const;
  RemovalVerdict judgeEdges(Index apex, Index vanishing);
  bool meetsSurfaceAgain(std::span<const Index> faces, Index apex);

  const TetMesh& mesh_;
  const Ridges& ridges_;
  double cosine_;
  Traversal traversal_;
  std::vector<EdgeUse> edges_;
  std::vector<Index> newEnds_;   // vertices that new edges join to the apex
  std::vector<Index> rimAtApex_; // vertices that edges of the rim join to it already
  std::vector<Index> ball_;
};
} // namespace ransmesh

// Takes edges away from a vertex, so that what is left of its ball can be starred without it.
#pragma once

#include "Mesh/Star.h"
#include "Mesh/Traversal.h"
#include "Removal/GrowingCavity.h"
#include "Removal/RemovalLimits.h"
#include "Removal/SurfaceStar.h"

#include <vector>

namespace ransmesh
{
class ValenceReduction
{
public:
  ValenceReduction(TetMesh& mesh, const BoundaryRules& rules, double cosine)
    : mesh_(mesh)
    , rules_(rules)
    , star_(mesh)
    , traversal_(mesh)
    , cavity_(mesh, rules)
    , surface_(mesh, rules.classification.ridges, cosine)
  {
  }

  // Takes out the edge at v that leaves the best quality, within the limits of quality. Edges on the
  // surface go only where the surface may change. The valence of v falls by one.
  bool cutEdge(Index v, const RemovalLimits& limits);

  // The tetrahedra made by the last successful cut.
  const std::vector<Index>& made() const { return *made_; }

private:
  struct Cut
  {
    Index end;
    Index apex;
    double quality;
  };

  void collectCuts(Index v, const RemovalLimits& limits);
  void considerEdge(Index tet, Index v, Index end, const RemovalLimits& limits);
  double floorFor(const RemovalLimits& limits) const;
  bool beginAt(Index tet, Index v, Index end);
  bool apply(Index v, const Cut& cut);

  TetMesh& mesh_;
  const BoundaryRules& rules_;
  Star star_;
  Traversal traversal_;
  GrowingCavity cavity_;
  SurfaceStar surface_;
  Marks seen_;
  std::vector<Index> ball_;
  std::vector<Index> ring_;
  std::vector<Index> apexes_;
  std::vector<Cut> cuts_;
  const std::vector<Index>* made_ = nullptr;
};
} // namespace ransmesh

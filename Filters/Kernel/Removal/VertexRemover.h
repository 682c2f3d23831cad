// Takes single points out of a mesh, with the checks of section 6 of Loehner's paper.
#pragma once

#include "Improvement/GrowingCavity.h"
#include "Mesh/Star.h"
#include "Mesh/Traversal.h"
#include "Removal/LayerRegion.h"
#include "Removal/RemovalLimits.h"
#include "Removal/RemovalVerdict.h"
#include "Removal/SurfaceStar.h"

#include <span>
#include <utility>
#include <vector>

namespace ransmesh
{
class VertexRemover
{
public:
  // cosine: of the largest angle by which a boundary face or a ridge may turn. Marks of region are
  // taken away as points go.
  VertexRemover(TetMesh& mesh, BoundaryRules& rules, LayerRegion& region, double cosine);

  // Tries to remove the marked vertex v, to the neighbour that leaves the best quality. The mesh is
  // valid before and after.
  RemovalVerdict remove(Index v, const RemovalLimits& limits);

  // The neighbour to which v could go if the fewest tetrahedra gave way.
  Index nearestApex(Index v, const RemovalLimits& limits);

  // Marked points that went with others' cavities.
  std::size_t absorbed() const { return absorbed_; }
  // The tetrahedra made by the last successful removal.
  const std::vector<Index>& made() const { return *made_; }

private:
  struct Candidate
  {
    Index apex;
    double floor; // that it was judged with
  };

  void begin(Index v);
  double floorFor(const RemovalLimits& limits) const;
  void collectApexes(Index v);
  bool ridgeTurns(Index v) const;
  void rankApexes(const RemovalLimits& limits);
  void keepPromisingApexes(double floor, std::size_t enough);
  double worstFrom(Index apex, double floor, const RemovalLimits& limits);
  RemovalVerdict tryApex(Index v, Index apex);
  bool losesOnlyMarked(Index v) const;
  bool isOverLarge(Index v, Index apex) const;
  void forgetLost(Index v, Index apex);

  TetMesh& mesh_;
  BoundaryRules& rules_;
  LayerRegion& region_;
  double cosine_;
  Star star_;
  Traversal traversal_;
  GrowingCavity cavity_;
  SurfaceStar surface_;
  Marks seen_;
  std::vector<Index> ball_;
  std::vector<Index> apexes_;
  std::vector<Candidate> candidates_;
  std::vector<std::pair<std::size_t, Index>> ranking_; // poor faces, apex
  const std::vector<Index>* made_ = nullptr;
  std::size_t absorbed_ = 0;
};
} // namespace ransmesh

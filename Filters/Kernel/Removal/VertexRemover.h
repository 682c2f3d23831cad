// Takes single points out of a mesh, with the checks of section 6 of Loehner's paper.
#pragma once

#include "Boundary/BoundaryRules.h"
#include "Improvement/VertexLink.h"
#include "Mesh/Star.h"
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
  VertexRemover(TetMesh& mesh, BoundaryRules& rules, LayerRegion& region, double cosine,
    SurfaceMemory& surfaces, SurfaceMemory& ridges);

  // Tries to remove the marked vertex v, to the neighbour that leaves the best quality. The mesh is
  // valid before and after.
  RemovalVerdict remove(Index v, const RemovalLimits& limits);

  // Whether the boundary's shape needs v: it lies on a surface or a ridge that would turn too far, come too far from
  // what it was, lose another ridge, or get a wall triangle with an angle above wallAngle, degrees, to whichever
  // neighbour v went.
  bool isNeededByShape(Index v, double wallAngle);

  // No tetrahedron that comes when v goes may be worse.
  double floorAt(Index v, const RemovalLimits& limits);

  // The neighbour to which v could go if the fewest tetrahedra gave way.
  Index nearestApex(Index v, const RemovalLimits& limits);

  // Marked points that went with others' cavities.
  std::size_t absorbed() const { return absorbed_; }
  // The tetrahedra made by the last successful removal, and the worst quality among them.
  const std::vector<Index>& made() const { return made_; }
  double worstMade() const { return worstMade_; }

private:
  struct Candidate
  {
    int end; // local number in link_
    double floor;
    double worst; // quality if v went there
  };

  void look(Index v);
  void collectSurfaceEnds(Index v);
  bool ridgeTurns(Index v) const;
  bool ridgeStaysInPlace(Index v);
  double floorFor(const RemovalLimits& limits) const;
  void rank(Index v, double floor, std::size_t growth);
  void rankAmong(std::span<const int> ends, bool onlyBetter, double floor, std::size_t growth);
  void keepPromisingEnds(Index v, double floor, std::size_t enough);
  std::size_t endsThatStayFirst();
  RemovalVerdict tryEnd(Index v, const Candidate& candidate, const RemovalLimits& limits);
  RemovalVerdict tryCollapse(Index v, const Candidate& candidate, double wallAngle);
  RemovalVerdict tryCavity(Index v, const Candidate& candidate, double wallAngle);
  RemovalVerdict judgeSurface(Index v, Index apex, double wallAngle);
  bool collapseIsOverLarge(Index v, int end) const;
  bool cavityIsOverLarge(Index v, Index apex) const;
  bool losesOnlyMarked(Index v) const;
  void forget(Index v, Index apex);

  TetMesh& mesh_;
  BoundaryRules& rules_;
  LayerRegion& region_;
  double cosine_;
  Star star_;
  VertexLink link_;
  SurfaceStar surface_;
  SurfaceMemory& ridgeMemory_;
  Cavity cavity_;
  bool changesSurface_ = false; // the cavity judged last
  std::vector<Index> surfaceEnds_;
  std::vector<int> ends_; // those to which v may go, by local number
  std::vector<Candidate> candidates_;
  std::vector<std::pair<std::size_t, int>> ranking_; // poor faces, end
  std::vector<Index> made_;
  double worstMade_ = 0;
  std::size_t absorbed_ = 0;
};
} // namespace ransmesh

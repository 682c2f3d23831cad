// Turns edges of walls where the removal has taken points from them.
#pragma once

#include "Boundary/BoundaryRules.h"
#include "Removal/PoorMending.h"
#include "Removal/ValenceReduction.h"

#include <cstddef>
#include <span>
#include <vector>

namespace ransmesh
{
class WallTurning
{
public:
  WallTurning(
    const TetMesh& mesh, const BoundaryRules& rules, ValenceReduction& valence, PoorMending& mending)
    : mesh_(mesh)
    , rules_(rules)
    , valence_(valence)
    , mending_(mending)
  {
  }

  // To be told of the tetrahedra made where a point of a wall went.
  void note(std::span<const Index> made);

  // Turns edges of the walls' triangles that were noted: where that makes their largest angle smaller, and
  // where they join two ridges, as the grids of both ridges need points between them. How many.
  std::size_t turnAll();

private:
  std::size_t turnWhereAnglesAreLarge();
  std::size_t separateRidges();
  bool turnLongestEdge(Index face);
  bool turnBetweenRidges(Index face);
  bool turn(Index from, Index to, const RemovalLimits& limits);

  const TetMesh& mesh_;
  const BoundaryRules& rules_;
  ValenceReduction& valence_;
  PoorMending& mending_;
  std::vector<Index> faces_;
};
} // namespace ransmesh

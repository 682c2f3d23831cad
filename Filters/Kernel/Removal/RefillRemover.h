// Takes a point out of the volume where neither collapses nor starred cavities do: what is around it is filled anew.
#pragma once

#include "Mesh/TetMesh.h"
#include "Mesh/Traversal.h"
#include "Removal/CavityFilling.h"

#include <array>
#include <cstddef>
#include <vector>

namespace ransmesh
{
class RefillRemover
{
public:
  enum class Verdict
  {
    Removed,
    Needed, // looked through all ways: what is around the point, two rings of tetrahedra far, cannot be filled without
    GivenUp // too many points around it, or too many ways
  };

  explicit RefillRemover(TetMesh& mesh)
    : mesh_(mesh)
    , traversal_(mesh)
  {
  }

  // Tries to remove v, which must not be on the boundary: its ball, or the ball with up to three rings of tetrahedra
  // around it, is filled without it, as well as it was if possible, but by nothing whose quality is not above least.
  Verdict remove(Index v, double least);

  // The tetrahedra made by the last successful removal.
  const std::vector<Index>& made() const { return made_; }

private:
  // What is to be filled.
  struct Place
  {
    std::vector<Index> tets;
    std::vector<Index> vertices; // by number in filling
    CavityFilling filling;
  };

  void collectPlaces(Index v);
  bool describe(Place& place, Index without) const;
  void addRing(std::vector<Index>& tets) const;
  CavityFilling::Verdict tryAt(Place& place, double floor);
  void apply(const Place& place);

  TetMesh& mesh_;
  Traversal traversal_;
  std::vector<Place> places_; // each within the next one
  std::vector<Index> made_;
  std::size_t stepsLeft_ = 40000; // for all points together
};
} // namespace ransmesh

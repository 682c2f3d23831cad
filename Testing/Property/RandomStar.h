// Stars of chosen cavities from chosen apexes.
#pragma once

#include "Boundary/Classification.h"
#include "Choices.h"
#include "Mesh/Star.h"

#include <cstddef>

namespace kernel_driver
{
class RandomStar
{
public:
  // Points of patches may be lost where these are plane.
  RandomStar(
    ransmesh::TetMesh& mesh, const ransmesh::Classification& classification, bool isPlane, Choices& choices)
    : mesh_(mesh)
    , classification_(classification)
    , isPlane_(isPlane)
    , choices_(choices)
  {
  }

  // Stars a cavity around the tetrahedron, if that may be.
  void tryAt(ransmesh::Index tet);

private:
  void growCavity(ransmesh::Cavity& cavity, std::size_t count);
  bool chooseApex(ransmesh::Cavity& cavity, ransmesh::Index& apex);
  void starFacesInPlane(ransmesh::Cavity& cavity, ransmesh::Index apex, int patch) const;
  bool losesOnlyInnerPoints(const ransmesh::Star& star) const;

  ransmesh::TetMesh& mesh_;
  const ransmesh::Classification& classification_;
  bool isPlane_;
  Choices& choices_;
};
} // namespace kernel_driver

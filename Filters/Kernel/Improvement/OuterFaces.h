// A set of tetrahedra to be starred again from a vertex yet to be chosen, and how good that would be.
#pragma once

#include "Mesh/LocalNumbers.h"
#include "Mesh/Star.h"
#include "Mesh/TetMesh.h"

#include <array>
#include <initializer_list>
#include <span>
#include <vector>

namespace ransmesh
{
class OuterFaces
{
public:
  explicit OuterFaces(const TetMesh& mesh)
    : mesh_(mesh)
  {
  }

  // Turns to these tetrahedra; of their boundary faces, those that have all vertices in vanishing (none,
  // a vertex, or an edge) are to be starred again.
  void turnTo(std::span<const Index> tets, std::initializer_list<Index> vanishing);

  // The worst quality of the tetrahedra that would come; gives up, with floor or less, as soon as one is
  // not better than floor.
  double worstFrom(Index apex, double floor);

  const Cavity& cavity() const { return cavity_; }

private:
  using Face = std::array<Index, 3>; // turned inward

  void addFaces(Index tet, std::span<const Index> vanishing);

  const TetMesh& mesh_;
  Cavity cavity_;
  LocalMarks inCavity_;
  std::vector<Face> faces_; // but for those to be starred
};
} // namespace ransmesh

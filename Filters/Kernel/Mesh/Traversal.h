// Walks over a mesh: the ball of a vertex, the ring of an edge.
#pragma once

#include "Mesh/LocalNumbers.h"
#include "Mesh/TetMesh.h"
#include "Support/Scratch.h"

#include <vector>

namespace ransmesh
{
// Scratch memory for walks; one for each thread that walks.
class Traversal
{
public:
  explicit Traversal(const TetMesh& mesh)
    : mesh_(mesh)
  {
  }

  // All tetrahedra at vertex v, which must be used.
  void ball(Index v, std::vector<Index>& out);
  // All tetrahedra at the edge (a, b), beginning with first, which must have both.
  void ring(Index first, Index a, Index b, std::vector<Index>& out);

private:
  const TetMesh& mesh_;
  LocalMarks seen_;
  Scratch<Index> found_;
};
} // namespace ransmesh

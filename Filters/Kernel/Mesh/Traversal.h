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
  // The first tetrahedron at vertex v that the question is true of, or None: the walk over the ball ends there.
  template <class Question>
  Index findInBall(Index v, Question question);
  // All tetrahedra at the edge (a, b), beginning with first, which must have both.
  void ring(Index first, Index a, Index b, std::vector<Index>& out);

private:
  const TetMesh& mesh_;
  LocalMarks seen_;
  Scratch<Index> found_;
};

template <class Question>
Index Traversal::findInBall(Index v, Question question)
{
  seen_.clear();
  found_.clear();
  found_.makeRoom(1);
  found_.add(mesh_.tetAt(v));
  seen_.set(found_[0]);
  for (std::size_t i = 0; i < found_.size(); ++i)
  {
    if (question(found_[i]))
    {
      return found_[i];
    }
    found_.makeRoom(4);
    const Tetrahedron& tet = mesh_.tet(found_[i]);
    for (int f = 0; f < 4; ++f)
    {
      const HalfFace other = tet.neighbour[f];
      if (tet.vertex[f] != v && !isBoundary(other) && seen_.set(tetOf(other)))
      {
        mesh_.fetchAhead(tetOf(other));
        found_.add(tetOf(other));
      }
    }
  }
  return None;
}
} // namespace ransmesh

#include "Mesh/Traversal.h"

namespace ransmesh
{
void Traversal::ball(Index v, std::vector<Index>& out)
{
  seen_.clear();
  found_.clear();
  found_.makeRoom(1);
  found_.add(mesh_.tetAt(v));
  seen_.set(found_[0]);
  for (std::size_t i = 0; i < found_.size(); ++i)
  {
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
  out.assign(found_.view().begin(), found_.view().end());
}

void Traversal::ring(Index first, Index a, Index b, std::vector<Index>& out)
{
  seen_.clear();
  out.assign(1, first);
  seen_.set(first);
  for (std::size_t i = 0; i < out.size(); ++i)
  {
    const Tetrahedron& tet = mesh_.tet(out[i]);
    for (int f = 0; f < 4; ++f)
    {
      const HalfFace other = tet.neighbour[f];
      if (tet.vertex[f] != a && tet.vertex[f] != b && !isBoundary(other) && seen_.set(tetOf(other)))
      {
        out.push_back(tetOf(other));
      }
    }
  }
}
} // namespace ransmesh

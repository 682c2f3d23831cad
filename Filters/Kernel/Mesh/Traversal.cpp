#include "Mesh/Traversal.h"

namespace ransmesh
{
void Traversal::ball(Index v, std::vector<Index>& out)
{
  findInBall(v, [](Index) { return false; });
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

#include "Boundary/EdgeUses.h"

#include <algorithm>
#include <tuple>

namespace ransmesh
{
void collectEdgeUses(const TetMesh& mesh, std::span<const Index> faces, std::vector<EdgeUse>& edges)
{
  edges.clear();
  for (const Index b : faces)
  {
    const auto v = mesh.boundaryVertices(b);
    for (int j = 0; j < 3; ++j)
    {
      const Index from = v[j];
      const Index to = v[(j + 1) % 3];
      edges.push_back({ std::min(from, to), std::max(from, to), { from, to }, b });
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const EdgeUse& a, const EdgeUse& b)
    { return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face); });
}
} // namespace ransmesh

#include "Mesh/Traversal.h"

#include "Support/GridMesh.h"
#include "Support/Invariants.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using namespace ransmesh;

std::vector<Index> tetsWith(const TetMesh& mesh, const std::vector<Index>& vertices)
{
  std::vector<Index> found;
  for (Index t = 0; t < static_cast<Index>(mesh.tetSlots()); ++t)
  {
    if (std::all_of(vertices.begin(), vertices.end(), [&](Index v) { return mesh.tet(t).has(v); }))
    {
      found.push_back(t);
    }
  }
  return found;
}

TEST(Traversal, BallHoldsAllTetrahedraAtAVertex)
{
  const TetMesh mesh = invariants::build(grid_mesh::make({ 4, 3, 2, {}, 0.2 }));
  Traversal traversal(mesh);
  std::vector<Index> ball;
  for (Index v = 0; v < static_cast<Index>(mesh.vertexCount()); ++v)
  {
    traversal.ball(v, ball);
    std::sort(ball.begin(), ball.end());
    EXPECT_EQ(ball, tetsWith(mesh, { v }));
  }
}

TEST(Traversal, RingHoldsAllTetrahedraAtAnEdge)
{
  const TetMesh mesh = invariants::build(grid_mesh::make({ 3, 3, 2, {}, 0.2 }));
  Traversal traversal(mesh);
  std::vector<Index> ring;
  for (Index t = 0; t < static_cast<Index>(mesh.tetSlots()); ++t)
  {
    for (int i = 0; i < 4; ++i)
    {
      for (int j = i + 1; j < 4; ++j)
      {
        const Index a = mesh.tet(t).vertex[i];
        const Index b = mesh.tet(t).vertex[j];
        traversal.ring(t, a, b, ring);
        EXPECT_EQ(ring.front(), t);
        std::sort(ring.begin(), ring.end());
        EXPECT_EQ(ring, tetsWith(mesh, { a, b }));
      }
    }
  }
}
} // namespace

#include "Removal/RefillRemover.h"

#include "Support/GridMesh.h"
#include "Support/Invariants.h"
#include "Support/WallStar.h"

#include <gtest/gtest.h>

namespace
{
using namespace ransmesh;
using Verdict = RefillRemover::Verdict;

TEST(RefillRemover, TakesAPointOutWhereNoCornerSeesWhole)
{
  const MeshData before = wall_star::meshOf(wall_star::cube(), { 0.4, 0.5, 0.6 });
  TetMesh mesh = invariants::build(before);
  RefillRemover remover(mesh);
  ASSERT_EQ(remover.remove(8, 0.01), Verdict::Removed);
  EXPECT_EQ(remover.made().size(), 6u);
  EXPECT_EQ(mesh.tetAt(8), None);
  invariants::expectValid(mesh);
  invariants::expectKept(before, toMeshData(mesh));
}

TEST(RefillRemover, KnowsThePointsThatWallsNeed)
{
  const MeshData before = wall_star::meshOf(wall_star::schoenhardt(), { 0, 0, 0.5 });
  TetMesh mesh = invariants::build(before);
  RefillRemover remover(mesh);
  EXPECT_EQ(remover.remove(6, 1e-6), Verdict::Needed);
  EXPECT_EQ(mesh.liveTets(), before.tetrahedra.size());
}

TEST(RefillRemover, TakesPointsOutOfAGrid)
{
  const MeshData before = grid_mesh::make({ 5, 5, 5, {}, 0.2 });
  TetMesh mesh = invariants::build(before);
  RefillRemover remover(mesh);
  std::size_t removed = 0;
  for (std::size_t i = 0; i < before.points.size(); ++i)
  {
    const Vector3& p = before.points[i];
    const bool isInside = std::min({ p.x, p.y, p.z }) > 0 && std::max({ p.x, p.y, p.z }) < 1;
    removed += isInside && i % 7 == 0 && remover.remove(static_cast<Index>(i), 1e-3) == Verdict::Removed;
  }
  EXPECT_GT(removed, 3u);
  invariants::expectValid(mesh);
  invariants::expectKept(before, toMeshData(mesh));
}
} // namespace

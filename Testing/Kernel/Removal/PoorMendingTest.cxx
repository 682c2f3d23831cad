#include "Removal/PoorMending.h"

#include "Support/GridMesh.h"
#include "Support/Invariants.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace ransmesh;

namespace
{
class PoorMendings : public testing::Test
{
protected:
  double worst() const
  {
    double worst = 1;
    for (Index t = 0; t < static_cast<Index>(mesh_.tetSlots()); ++t)
    {
      worst = mesh_.tet(t).isAlive() ? std::min(worst, qualityOf(mesh_, t)) : worst;
    }
    return worst;
  }

  std::vector<Index> all() const
  {
    std::vector<Index> tets;
    for (Index t = 0; t < static_cast<Index>(mesh_.tetSlots()); ++t)
    {
      if (mesh_.tet(t).isAlive())
      {
        tets.push_back(t);
      }
    }
    return tets;
  }

  TetMesh mesh_ = invariants::build(grid_mesh::make({ 4, 4, 4, grid_mesh::turned, 0.4 }));
  PatchTable patches_ = grid_mesh::patches(PatchType::Symmetry);
  BoundaryRules rules_{ classify(mesh_, patches_), std::vector<char>(patches_.size(), 0) };
  PoorMending mending_{ mesh_, rules_ };
};

TEST_F(PoorMendings, MendsWhatWasNotedAndNothingElse)
{
  ASSERT_LT(worst(), PoorQuality);
  mending_.note(all(), 0);
  mending_.begin();
  EXPECT_EQ(mending_.mendAll(PoorQuality), 0u) << "nothing was poor by the quality given";
  const double before = worst();
  mending_.note(all(), PoorQuality);
  EXPECT_GT(mending_.mendAll(PoorQuality), 0u);
  EXPECT_GE(worst(), before);
  invariants::expectValid(mesh_);
}

// What is remembered of vain attempts must not keep any swap from being done that a fresh look would do.
TEST_F(PoorMendings, RemembersOnlyWhatIsStillInVain)
{
  const auto sweep = [this](PoorMending& mending)
  {
    std::size_t swaps = 0;
    mending.begin();
    for (Index v = 0; v < static_cast<Index>(mesh_.vertexCount()); ++v)
    {
      swaps += mending.swapAround(v, PoorQuality);
    }
    return swaps;
  };
  std::size_t swaps = 0;
  for (std::size_t more = sweep(mending_); more > 0; more = sweep(mending_))
  {
    swaps += more;
    ASSERT_LT(swaps, 10'000u);
  }
  EXPECT_GT(swaps, 0u);
  PoorMending fresh(mesh_, rules_);
  EXPECT_EQ(sweep(fresh), 0u);
  invariants::expectValid(mesh_);
}

TEST_F(PoorMendings, TriesAgainWhereOthersHaveChangedTheMesh)
{
  mending_.note(all(), PoorQuality);
  mending_.begin();
  mending_.mendAll(PoorQuality);
  // The best place for a point of the volume, spoilt and told of.
  Index v = 0;
  while (rules_.classification.kind[v] != VertexKind::Volume)
  {
    ++v;
  }
  const Vector3 from = mesh_.point(v);
  EXPECT_TRUE(mending_.moveTowards(v, from + Vector3{ 0.1, 0.05, 0.02 }, -1e3));
  EXPECT_NE(mesh_.point(v), from);
  TetMesh copy = mesh_;
  PoorMending fresh(copy, rules_);
  fresh.begin();
  mending_.begin();
  const std::size_t swaps = mending_.swapAround(v, 1);
  EXPECT_GT(swaps, 0u);
  EXPECT_EQ(swaps, fresh.swapAround(v, 1));
  invariants::expectValid(mesh_);
}
} // namespace

// Tops that others have closed in, on the floor of a trough.
#include "Insertion/GroupRaising.h"

#include "Layers/ColumnBuilder.h"
#include "Mesh/Builder.h"
#include "Support/GridMesh.h"
#include "Support/Invariants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

using namespace ransmesh;
using namespace grid_mesh;

namespace
{
constexpr MoveEffort Hardest{ 1e-15, 60 };

// Half a pipe of radius 1 with 4 x 4 points on its wall, which have columns of 0.2.
class Trough
{
public:
  Trough()
    : table_(patches(PatchType::Symmetry))
    , mesh_(invariants::build(make({ 3, 3, 4, bent, 0.2 })))
  {
    LayerPlan plan(7);
    plan[ZLow].firstHeight = 0.025;
    plan[ZLow].growthRate = 1;
    plan[ZLow].numberOfLayers = 8;
    set_ = buildColumns(mesh_, BoundaryStars(mesh_), table_, plan);
    classes_ = classify(mesh_, table_);
    front_ = std::make_unique<Front>(mesh_, set_);
    turns_ = std::make_unique<SideTurns>(mesh_, set_, 10);
    moves_ = std::make_unique<FrontMoves>(mesh_, set_, classes_, *turns_, *front_);
  }

  // Moves the tops out one after the other in any order, each as far as it comes: at once, or else in small steps.
  void raiseOneByOne(unsigned seed)
  {
    std::vector<Index> order;
    for (std::size_t i = 0; i < set_.columns.size(); ++i)
    {
      order.push_back(static_cast<Index>(i));
    }
    std::mt19937 random(seed);
    for (std::size_t i = order.size() - 1; i > 0; --i)
    {
      std::swap(order[i], order[random() % (i + 1)]);
    }
    for (const double step : { 1.0, 1.0, 0.02, 0.02 })
    {
      for (const Index c : order)
      {
        while (front_->share(c) < 1 && raise(c, std::min(1.0, front_->share(c) + step)))
        {
        }
      }
    }
  }
  bool raiseTogether(const Context& context = {})
  {
    return GroupRaising(mesh_, set_, *front_, *moves_).run(context);
  }

  int levelsMissing() const
  {
    int missing = 0;
    for (std::size_t c = 0; c < set_.columns.size(); ++c)
    {
      missing += set_.columns[c].levels - front_->levelsReached(static_cast<Index>(c));
    }
    return missing;
  }
  TetMesh& mesh() { return mesh_; }
  ColumnSet& set() { return set_; }
  const Front& front() const { return *front_; }

private:
  static Vector3 bent(const Vector3& p)
  {
    const double angle = 3 * (p.y - 0.5);
    const double radius = 1 - 0.9 * p.z;
    return { p.x, radius * std::sin(angle), -radius * std::cos(angle) };
  }
  bool raise(Index c, double share)
  {
    const bool done = isDone(moves_->move(c, front_->position(c, share > 0.999 ? 1 : share), Hardest));
    front_->setShare(c, done ? (share > 0.999 ? 1 : share) : front_->share(c));
    return done;
  }

  PatchTable table_;
  TetMesh mesh_;
  ColumnSet set_;
  Classification classes_;
  std::unique_ptr<Front> front_;
  std::unique_ptr<SideTurns> turns_;
  std::unique_ptr<FrontMoves> moves_;
};
} // namespace

TEST(GroupRaising, AClosedInTopRisesWithItsNeighbours)
{
  int closedIn = 0;
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    Trough trough;
    trough.raiseOneByOne(seed);
    closedIn += trough.levelsMissing() > 0 ? 1 : 0;
    ASSERT_TRUE(trough.raiseTogether());
    EXPECT_EQ(trough.levelsMissing(), 0) << "seed " << seed;
    invariants::expectValid(trough.mesh());
  }
  EXPECT_GT(closedIn, 3);
}

TEST(GroupRaising, WhatBecomesNoBetterIsUndone)
{
  Trough trough;
  Column& c = trough.set().columns[5];
  c.direction = -4 * c.direction; // its next level lies behind the wall
  trough.raiseOneByOne(0);
  const int missing = trough.levelsMissing();
  ASSERT_EQ(missing, c.levels);
  const MeshData before = toMeshData(trough.mesh());
  ASSERT_TRUE(trough.raiseTogether());
  EXPECT_EQ(trough.levelsMissing(), missing);
  const MeshData after = toMeshData(trough.mesh());
  EXPECT_EQ(after.points, before.points);
  EXPECT_EQ(after.tetrahedra, before.tetrahedra);
  for (std::size_t i = 0; i < trough.set().columns.size(); ++i)
  {
    EXPECT_EQ(trough.mesh().point(trough.set().columns[i].vertex),
      trough.front().position(static_cast<Index>(i), trough.front().share(static_cast<Index>(i))));
  }
}

TEST(GroupRaising, StopsWhenCancelled)
{
  Trough trough;
  trough.set().columns[5].direction = -4 * trough.set().columns[5].direction;
  trough.raiseOneByOne(0);
  Context context;
  context.cancelled = [] { return true; };
  EXPECT_FALSE(trough.raiseTogether(context));
}

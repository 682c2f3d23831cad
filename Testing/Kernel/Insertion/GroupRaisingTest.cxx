// Tops that others have closed in, on the floor of a trough.
#include "Insertion/GroupRaising.h"

#include "Support/GridMesh.h"
#include "Support/RisingFront.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace ransmesh;
using namespace grid_mesh;

namespace
{
constexpr MoveEffort Hardest{ 1e-15, 60 };

// Half a pipe of radius 1 with 4 x 4 points on its wall, which have columns of 0.2.
class Trough : public RisingFront
{
public:
  Trough()
    : RisingFront(make({ 3, 3, 4, bent, 0.2 }), patches(PatchType::Symmetry), eightLevels())
  {
  }

  // Moves the tops out one after the other in any order, each as far as it comes: at once, or else in small steps.
  void raiseOneByOne(unsigned seed)
  {
    std::vector<Index> order;
    for (std::size_t i = 0; i < set.columns.size(); ++i)
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
        while (front.share(c) < 1 && raise(c, std::min(1.0, front.share(c) + step)))
        {
        }
      }
    }
  }
  bool raiseTogether(const Context& context = {})
  {
    return GroupRaising(mesh, set, front, moves).run(context);
  }

  int levelsMissing() const
  {
    int missing = 0;
    for (std::size_t c = 0; c < set.columns.size(); ++c)
    {
      missing += set.columns[c].levels - front.levelsReached(static_cast<Index>(c));
    }
    return missing;
  }

private:
  static LayerPlan eightLevels()
  {
    LayerPlan plan(7);
    plan[ZLow].firstHeight = 0.025;
    plan[ZLow].growthRate = 1;
    plan[ZLow].numberOfLayers = 8;
    return plan;
  }
  static Vector3 bent(const Vector3& p)
  {
    const double angle = 3 * (p.y - 0.5);
    const double radius = 1 - 0.9 * p.z;
    return { p.x, radius * std::sin(angle), -radius * std::cos(angle) };
  }
  bool raise(Index c, double share)
  {
    const bool done = isDone(moves.move(c, front.position(c, share > 0.999 ? 1 : share), Hardest));
    front.setShare(c, done ? (share > 0.999 ? 1 : share) : front.share(c));
    return done;
  }
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
    invariants::expectValid(trough.mesh);
  }
  EXPECT_GT(closedIn, 3);
}

TEST(GroupRaising, WhatBecomesNoBetterIsUndone)
{
  Trough trough;
  Column& c = trough.set.columns[5];
  c.direction = -4 * c.direction; // its next level lies behind the wall
  trough.raiseOneByOne(0);
  const int missing = trough.levelsMissing();
  ASSERT_EQ(missing, c.levels);
  const MeshData before = toMeshData(trough.mesh);
  ASSERT_TRUE(trough.raiseTogether());
  EXPECT_EQ(trough.levelsMissing(), missing);
  const MeshData after = toMeshData(trough.mesh);
  EXPECT_EQ(after.points, before.points);
  EXPECT_EQ(after.tetrahedra, before.tetrahedra);
  for (std::size_t i = 0; i < trough.set.columns.size(); ++i)
  {
    EXPECT_EQ(trough.mesh.point(trough.set.columns[i].vertex),
      trough.front.position(static_cast<Index>(i), trough.front.share(static_cast<Index>(i))));
  }
}

TEST(GroupRaising, StopsWhenCancelled)
{
  Trough trough;
  trough.set.columns[5].direction = -4 * trough.set.columns[5].direction;
  trough.raiseOneByOne(0);
  Context context;
  context.cancelled = [] { return true; };
  EXPECT_FALSE(trough.raiseTogether(context));
}

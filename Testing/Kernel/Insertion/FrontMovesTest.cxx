// Single moves of the front's tops over a plate.
#include "Insertion/FrontMoves.h"

#include "Geometry/TetrahedronMeasures.h"
#include "Support/GridMesh.h"
#include "Support/RisingFront.h"

#include <gtest/gtest.h>

using namespace ransmesh;
using namespace grid_mesh;

namespace
{
// Columns of 0.2 on a plate of 4 x 4 cells of 0.25, the front still on the wall.
class FrontMovesOverAPlate : public testing::Test
{
protected:
  void SetUp() override
  {
    for (std::size_t i = 0; i < plate_.set.columns.size(); ++i)
    {
      const bool isMiddle = distance(plate_.set.columns[i].base, { 0.5, 0.5, 0 }) < 1e-9;
      middle_ = isMiddle ? static_cast<Index>(i) : middle_;
    }
    ASSERT_NE(middle_, None);
  }
  void TearDown() override { invariants::expectValid(plate_.mesh); }

  MoveVerdict move(const Vector3& by, const MoveEffort& effort = { 0.05, 8 })
  {
    return plate_.moves.move(middle_, plate_.set.columns[middle_].base + by, effort);
  }
  const Vector3& top() const { return plate_.mesh.point(plate_.set.columns[middle_].vertex); }

  static LayerPlan twoLevels()
  {
    LayerPlan plan(7);
    plan[ZLow].firstHeight = 0.1;
    plan[ZLow].growthRate = 1;
    plan[ZLow].numberOfLayers = 2;
    return plan;
  }

  RisingFront plate_{ make({ 4, 4, 4 }), patches(PatchType::Symmetry), twoLevels() };
  Index middle_ = None;
};
} // namespace

TEST_F(FrontMovesOverAPlate, ALittleWayIsAPlainMove)
{
  EXPECT_EQ(move({ 0, 0, 0.02 }), MoveVerdict::Moved);
  EXPECT_NEAR(top().z, 0.02, 1e-15);
}

TEST_F(FrontMovesOverAPlate, NoTopGoesBelowTheWallOrPastItsNeighbours)
{
  for (const Vector3& by : { Vector3{ 0, 0, -0.01 }, { 0.3, 0, 0 } })
  {
    EXPECT_EQ(move(by), MoveVerdict::SlabFolds);
    EXPECT_EQ(top(), (Vector3{ 0.5, 0.5, 0 }));
  }
}

TEST_F(FrontMovesOverAPlate, FartherThanTheNextPointTheMeshGivesWay)
{
  const std::size_t before = plate_.mesh.liveTets();
  EXPECT_EQ(move({ 0, 0, 0.3 }, { 0.01, 30 }), MoveVerdict::Restarred);
  EXPECT_NEAR(top().z, 0.3, 1e-15);
  EXPECT_NE(plate_.mesh.liveTets(), before);
}

TEST_F(FrontMovesOverAPlate, ThroughTheCeilingThereIsNoRoom)
{
  EXPECT_EQ(move({ 0, 0, 1.2 }), MoveVerdict::NoRoom);
  EXPECT_EQ(top(), (Vector3{ 0.5, 0.5, 0 }));
}

TEST_F(FrontMovesOverAPlate, NoMoveMakesTetrahedraPoorerThanItMay)
{
  // The next point above is at 0.25, and nothing beside the top may change.
  const auto qualityAt = [this](Index t)
  {
    const auto& v = plate_.mesh.tet(t).vertex;
    return quality(
      plate_.mesh.point(v[0]), plate_.mesh.point(v[1]), plate_.mesh.point(v[2]), plate_.mesh.point(v[3]));
  };
  int refused = 0;
  for (const double gap : { 1e-2, 1e-4, 1e-8, 1e-12, 1e-15 })
  {
    refused += isDone(move({ 0, 0, 0.25 - gap }, { LeastQualityOfMoves, 0 })) ? 0 : 1;
    for (std::size_t t = 0; t < plate_.mesh.tetSlots(); ++t)
    {
      const auto tet = static_cast<Index>(t);
      EXPECT_TRUE(!plate_.mesh.tet(tet).isAlive() || qualityAt(tet) > LeastQualityOfMoves) << gap;
    }
  }
  EXPECT_GT(refused, 0);
}

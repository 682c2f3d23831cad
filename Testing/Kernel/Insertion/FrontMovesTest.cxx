// Single moves of the front's tops over a plate.
#include "Insertion/FrontMoves.h"

#include "Geometry/Predicates.h"
#include "Layers/ColumnBuilder.h"
#include "Mesh/Builder.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <memory>

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
    const PatchTable table = patches(PatchType::Symmetry);
    ASSERT_TRUE(buildTetMesh(make({ 4, 4, 4 }), mesh_).ok());
    LayerPlan plan(7);
    plan[ZLow].firstHeight = 0.1;
    plan[ZLow].growthRate = 1;
    plan[ZLow].numberOfLayers = 2;
    set_ = buildColumns(mesh_, BoundaryStars(mesh_), table, plan);
    classes_ = classify(mesh_, table);
    front_ = std::make_unique<Front>(mesh_, set_);
    turns_ = std::make_unique<SideTurns>(mesh_, set_, 10);
    moves_ = std::make_unique<FrontMoves>(mesh_, set_, classes_, *turns_, *front_);
    for (std::size_t i = 0; i < set_.columns.size(); ++i)
    {
      middle_ = distance(set_.columns[i].base, { 0.5, 0.5, 0 }) < 1e-9 ? static_cast<Index>(i) : middle_;
    }
    ASSERT_NE(middle_, None);
  }

  MoveVerdict move(const Vector3& by, const MoveEffort& effort = { 0.05, 8 })
  {
    return moves_->move(middle_, set_.columns[middle_].base + by, effort);
  }
  const Vector3& top() const { return mesh_.point(set_.columns[middle_].vertex); }
  bool isPositiveEverywhere() const
  {
    for (std::size_t t = 0; t < mesh_.tetSlots(); ++t)
    {
      const auto& v = mesh_.tet(static_cast<Index>(t)).vertex;
      if (mesh_.tet(static_cast<Index>(t)).isAlive() &&
        !isPositive(mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]), mesh_.point(v[3])))
      {
        return false;
      }
    }
    return true;
  }

  TetMesh mesh_;
  ColumnSet set_;
  Classification classes_;
  std::unique_ptr<Front> front_;
  std::unique_ptr<SideTurns> turns_;
  std::unique_ptr<FrontMoves> moves_;
  Index middle_ = None;
};
} // namespace

TEST_F(FrontMovesOverAPlate, ALittleWayIsAPlainMove)
{
  EXPECT_EQ(move({ 0, 0, 0.02 }), MoveVerdict::Moved);
  EXPECT_NEAR(top().z, 0.02, 1e-15);
  EXPECT_TRUE(isPositiveEverywhere());
}

TEST_F(FrontMovesOverAPlate, NoTopGoesBelowTheWallOrPastItsNeighbours)
{
  for (const Vector3& by : { Vector3{ 0, 0, -0.01 }, { 0.3, 0, 0 } })
  {
    EXPECT_EQ(move(by), MoveVerdict::SlabFolds);
    EXPECT_EQ(top(), (Vector3{ 0.5, 0.5, 0 }));
  }
  EXPECT_TRUE(isPositiveEverywhere());
}

TEST_F(FrontMovesOverAPlate, FartherThanTheNextPointTheMeshGivesWay)
{
  const std::size_t before = mesh_.liveTets();
  EXPECT_EQ(move({ 0, 0, 0.3 }, { 0.01, 30 }), MoveVerdict::Restarred);
  EXPECT_NEAR(top().z, 0.3, 1e-15);
  EXPECT_NE(mesh_.liveTets(), before);
  EXPECT_TRUE(isPositiveEverywhere());
}

TEST_F(FrontMovesOverAPlate, ThroughTheCeilingThereIsNoRoom)
{
  EXPECT_EQ(move({ 0, 0, 1.2 }), MoveVerdict::NoRoom);
  EXPECT_EQ(top(), (Vector3{ 0.5, 0.5, 0 }));
  EXPECT_TRUE(isPositiveEverywhere());
}

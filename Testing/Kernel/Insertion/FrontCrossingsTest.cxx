// Fronts that would get in their own way.
#include "Insertion/FrontCrossings.h"

#include "Layers/ColumnBuilder.h"
#include "Mesh/Builder.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace ransmesh;
using namespace grid_mesh;

namespace
{
// Columns on the floor and on the ceiling of a cube of 4 x 4 x 4 cells that leans a little, of layers of 0.1. All are at
// first without any.
class FrontCrossingsInACube : public testing::Test
{
protected:
  void SetUp() override
  {
    ASSERT_TRUE(buildTetMesh(make({ 4, 4, 4, lean }), mesh_).ok());
    LayerPlan plan(7);
    for (const int wall : { ZLow, ZHigh })
    {
      plan[wall].firstHeight = 0.1;
      plan[wall].growthRate = 1;
      plan[wall].numberOfLayers = 12;
    }
    set_ = buildColumns(mesh_, BoundaryStars(mesh_), patches(PatchType::Symmetry), plan);
    for (Column& c : set_.columns)
    {
      c.levels = 0;
    }
  }
  static Vector3 lean(const Vector3& p) { return { p.x + 0.08 * p.z, p.y + 0.03 * p.z, p.z }; }
  // At what was x before the cube leant.
  Column& columnAt(const Vector3& x)
  {
    for (Column& c : set_.columns)
    {
      if (distance(c.base, lean(x)) < 1e-9)
      {
        return c;
      }
    }
    throw std::logic_error("no column there");
  }

  TetMesh mesh_;
  ColumnSet set_;
};
} // namespace

TEST_F(FrontCrossingsInACube, BothSidesAreLoweredToOneHeight)
{
  Column& floor = columnAt({ 0.5, 0.5, 0 });
  Column& ceiling = columnAt({ 0.5, 0.5, 1 });
  floor.levels = 9;
  ceiling.levels = 7;
  EXPECT_EQ(limitByCrossings(mesh_, set_), 2U);
  EXPECT_EQ(floor.levels, 4); // they touch at 0.5
  EXPECT_EQ(ceiling.levels, 4);
  EXPECT_EQ(floor.reason, StopReason::Gap);
  EXPECT_EQ(limitByCrossings(mesh_, set_), 0U);
}

TEST_F(FrontCrossingsInACube, ALowFrontStaysWhereAHighOneRunsIntoIt)
{
  Column& floor = columnAt({ 0.5, 0.5, 0 });
  Column& ceiling = columnAt({ 0.5, 0.5, 1 });
  floor.levels = 9;
  ceiling.levels = 3;
  EXPECT_EQ(limitByCrossings(mesh_, set_), 1U);
  EXPECT_LT(floor.levels, 7); // at which they touch
  EXPECT_GT(floor.levels, 4);
  EXPECT_EQ(ceiling.levels, 3);
}

TEST_F(FrontCrossingsInACube, FrontsThatPassEachOtherByStay)
{
  Column& floor = columnAt({ 0.5, 0.5, 0 });
  Column& ceiling = columnAt({ 0.5, 0.5, 1 });
  floor.levels = 6;
  ceiling.levels = 3;
  EXPECT_EQ(limitByCrossings(mesh_, set_), 0U);
  floor.levels = 0;
  ceiling.levels = 0;
  columnAt({ 0.25, 0.5, 0 }).levels = 9;
  columnAt({ 0.75, 0.5, 1 }).levels = 9;
  EXPECT_EQ(limitByCrossings(mesh_, set_), 0U);
}

TEST_F(FrontCrossingsInACube, AFrontIsLoweredBelowABareWall)
{
  Column& floor = columnAt({ 0.5, 0.5, 0 });
  floor.levels = 11;
  EXPECT_EQ(limitByCrossings(mesh_, set_), 1U);
  EXPECT_EQ(floor.levels, 7); // a fifth below the wall, and no higher
}

TEST_F(FrontCrossingsInACube, HeightsAroundDoNotDifferTooMuch)
{
  for (const double x : { 0.25, 0.5, 0.75 })
  {
    for (const double y : { 0.25, 0.5, 0.75 })
    {
      columnAt({ x, y, 0 }).levels = 8;
    }
  }
  columnAt({ 0.5, 0.5, 1 }).levels = 6;
  EXPECT_GT(limitByCrossings(mesh_, set_), 4U);
  EXPECT_LE(columnAt({ 0.5, 0.5, 0 }).levels, 4);
  EXPECT_LE(columnAt({ 0.5, 0.75, 0 }).levels, 5); // 0.4 and 0.7 of the 0.25 between them
  EXPECT_LT(columnAt({ 0.75, 0.75, 0 }).levels, 8);
  EXPECT_GT(columnAt({ 0.75, 0.75, 0 }).levels, 3);
}

TEST_F(FrontCrossingsInACube, WhatCannotBeLoweredStays)
{
  Column& floor = columnAt({ 0.5, 0.5, 0 });
  floor.levels = floor.lowest = 11;
  limitByCrossings(mesh_, set_);
  EXPECT_EQ(floor.levels, 11);
}

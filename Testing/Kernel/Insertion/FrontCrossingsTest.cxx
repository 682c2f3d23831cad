// Fronts that would get in their own way.
#include "Insertion/FrontCrossings.h"

#include "Layers/ColumnBuilder.h"
#include "Mesh/Builder.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

using namespace ransmesh;
using namespace grid_mesh;

namespace
{
// Columns on the floor and on the ceiling of a cube, the fronts still on the walls.
class FrontCrossingsInACube : public testing::Test
{
protected:
  void SetUp() override
  {
    ASSERT_TRUE(buildTetMesh(make({ 4, 4, 4 }), mesh_).ok());
    LayerPlan plan(7);
    for (const int wall : { ZLow, ZHigh })
    {
      plan[wall].firstHeight = 0.1;
      plan[wall].growthRate = 1;
      plan[wall].numberOfLayers = 12;
    }
    set_ = buildColumns(mesh_, BoundaryStars(mesh_), patches(PatchType::Symmetry), plan);
  }
  Index columnAt(const Vector3& x) const
  {
    for (std::size_t i = 0; i < set_.columns.size(); ++i)
    {
      if (distance(set_.columns[i].base, x) < 1e-9)
      {
        return static_cast<Index>(i);
      }
    }
    throw std::logic_error("no column there");
  }
  bool wouldCross(Index column, const Vector3& x) const
  {
    return FrontCrossings(mesh_, set_, { column }).wouldCross(column, x);
  }

  TetMesh mesh_;
  ColumnSet set_;
};
} // namespace

TEST_F(FrontCrossingsInACube, ATopCrossesTheOppositeFrontWhereThatStands)
{
  const Index column = columnAt({ 0.5, 0.5, 0 });
  EXPECT_FALSE(wouldCross(column, { 0.53, 0.48, 0.9 }));
  EXPECT_FALSE(wouldCross(column, { 0.53, 0.48, 1 })); // it touches
  EXPECT_TRUE(wouldCross(column, { 0.53, 0.48, 1.1 }));
  for (std::size_t i = 0; i < set_.columns.size(); ++i)
  {
    const Column& c = set_.columns[i];
    if (c.base.z > 0.5)
    {
      mesh_.movePoint(c.vertex, c.base - Vector3{ 0, 0, 0.3 });
    }
  }
  EXPECT_TRUE(wouldCross(column, { 0.53, 0.48, 0.9 }));
  EXPECT_FALSE(wouldCross(column, { 0.53, 0.48, 0.6 }));
}

TEST_F(FrontCrossingsInACube, AmidItsNeighboursATopCrossesNothing)
{
  const Index column = columnAt({ 0.5, 0.5, 0 });
  for (std::size_t i = 0; i < set_.columns.size(); ++i)
  {
    const Column& c = set_.columns[i];
    if (c.base.z < 0.5 && static_cast<Index>(i) != column)
    {
      mesh_.movePoint(c.vertex, c.base + Vector3{ 0, 0, 0.4 });
    }
  }
  for (const double z : { 0.0, 0.2, 0.4, 0.6 })
  {
    EXPECT_FALSE(wouldCross(column, { 0.5, 0.5, z })) << z;
  }
}

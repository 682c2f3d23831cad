#include "Layers/ColumnBuilder.h"

#include "Mesh/Builder.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace ransmesh;
using namespace grid_mesh;

namespace
{
struct Columns
{
  TetMesh mesh;
  ColumnSet set;

  Columns(const MeshData& data, const PatchTable& patches, const std::vector<int>& walls)
  {
    EXPECT_TRUE(buildTetMesh(data, mesh).ok());
    LayerPlan plan(patches.size());
    for (const int wall : walls)
    {
      plan[wall].firstHeight = 1e-3;
      plan[wall].numberOfLayers = 5;
    }
    const BoundaryStars stars(mesh);
    set = buildColumns(mesh, stars, patches, plan);
  }

  const Column* at(const Vector3& x) const
  {
    for (const Column& c : set.columns)
    {
      if (distance(c.base, x) < 1e-12)
      {
        return &c;
      }
    }
    return nullptr;
  }
};

void expectVector(const Vector3& is, const Vector3& wanted)
{
  EXPECT_NEAR(is.x, wanted.x, 1e-12);
  EXPECT_NEAR(is.y, wanted.y, 1e-12);
  EXPECT_NEAR(is.z, wanted.z, 1e-12);
}
} // namespace

TEST(ColumnBuilder, APlaneWallHasItsNormal)
{
  const Columns columns(make({ 4, 4, 4 }), patches(PatchType::Symmetry), { ZLow });
  EXPECT_EQ(columns.set.columns.size(), 25u);
  const Column* inner = columns.at({ 0.5, 0.5, 0 });
  ASSERT_TRUE(inner);
  expectVector(inner->direction, { 0, 0, 1 });
  EXPECT_EQ(inner->sides[0], 0);
  EXPECT_EQ(inner->levels, 5);
  EXPECT_GT(inner->size, 0.25);
  EXPECT_LT(inner->size, 0.36);
}

TEST(ColumnBuilder, AColumnAtASymmetryPlaneStaysInIt)
{
  const Columns columns(make({ 4, 4, 4 }), patches(PatchType::Symmetry), { ZLow });
  const Column* edge = columns.at({ 0, 0.5, 0 });
  ASSERT_TRUE(edge);
  expectVector(edge->direction, { 0, 0, 1 });
  EXPECT_TRUE(edge->staysIn(XLow));
  EXPECT_FALSE(edge->staysIn(ZLow));
  const Column* corner = columns.at({ 1, 1, 0 });
  ASSERT_TRUE(corner);
  expectVector(corner->direction, { 0, 0, 1 });
  EXPECT_TRUE(corner->staysIn(XHigh));
  EXPECT_TRUE(corner->staysIn(YHigh));
}

TEST(ColumnBuilder, ASlantedSideLeansTheColumnButKeepsTheHeight)
{
  // The side x = 0 leans outward by 45 degrees: its column has to run along it.
  const auto lean = [](const Vector3& p) { return Vector3{ p.x - (1 - p.x) * p.z, p.y, p.z }; };
  const Columns columns(make({ 4, 4, 4, lean }), patches(PatchType::Symmetry), { ZLow });
  const Column* edge = columns.at({ 0, 0.5, 0 });
  ASSERT_TRUE(edge);
  EXPECT_EQ(edge->levels, 5);
  expectVector(edge->direction, { -1, 0, 1 });
}

TEST(ColumnBuilder, AConcaveEdgeHasOneColumnAlongTheBisector)
{
  const Columns columns(make({ 4, 4, 4 }), patches(PatchType::Symmetry), { ZLow, XLow });
  const Column* edge = columns.at({ 0, 0.5, 0 });
  ASSERT_TRUE(edge);
  expectVector(edge->direction, { 1, 0, 1 }); // rises by one above either wall
  EXPECT_EQ(edge->levels, 5);
}

TEST(ColumnBuilder, WhereAWedgeClosesItsGapStopsTheColumn)
{
  const auto skew = [](const Vector3& p) { return Vector3{ p.x + 8 * p.z, p.y, p.z }; }; // 7 degrees
  const Columns columns(make({ 4, 4, 4, skew }), patches(PatchType::Symmetry), { ZLow, XLow });
  const Column* edge = columns.at({ 0, 0.5, 0 });
  ASSERT_TRUE(edge);
  EXPECT_EQ(edge->levels, 0);
  EXPECT_EQ(edge->reason, StopReason::Gap);
}

TEST(ColumnBuilder, WhereAWallClosesAGapToASymmetryPlaneStopsTheColumn)
{
  const auto skew = [](const Vector3& p) { return Vector3{ p.x + 8 * p.z, p.y, p.z }; }; // 7 degrees
  const Columns columns(make({ 4, 4, 4, skew }), patches(PatchType::Symmetry), { ZLow });
  const Column* edge = columns.at({ 0, 0.5, 0 });
  ASSERT_TRUE(edge);
  EXPECT_EQ(edge->levels, 0);
  EXPECT_EQ(edge->reason, StopReason::Gap);
}

TEST(ColumnBuilder, AStepIntoANarrowWedgeKeepsItsHeight)
{
  const double slope = std::tan(15 * M_PI / 180);
  const auto skew = [slope](const Vector3& p) { return Vector3{ p.x + p.z / slope, p.y, p.z }; };
  const Columns columns(make({ 4, 4, 4, skew }), patches(PatchType::Symmetry), { ZLow, XLow });
  const Column* edge = columns.at({ 0, 0.5, 0 });
  ASSERT_TRUE(edge);
  EXPECT_EQ(edge->levels, 5);
  EXPECT_NEAR(edge->direction.z, 1, 1e-9);
  EXPECT_NEAR(edge->direction.y, 0, 1e-12);
}

TEST(ColumnBuilder, AnInterfaceFreezesItsPoints)
{
  PatchTable table = patches(PatchType::Symmetry);
  table[XLow].type = PatchType::Interface;
  const Columns columns(make({ 4, 4, 4 }), table, { ZLow });
  EXPECT_EQ(columns.at({ 0, 0.5, 0 })->levels, 0);
  EXPECT_EQ(columns.at({ 0, 0.5, 0 })->reason, StopReason::Frozen);
  EXPECT_EQ(columns.at({ 0.25, 0.5, 0 })->levels, 5);
}

TEST(ColumnBuilder, AColumnStandsInACurvedSide)
{
  const auto bulge = [](const Vector3& p) {
    return Vector3{ p.x, p.y - 0.3 * (1 - p.y) * std::sin(M_PI * p.x), p.z };
  };
  const Columns columns(make({ 4, 4, 4, bulge }), patches(PatchType::Symmetry), { ZLow });
  const Column* column = columns.at({ 0.5, -0.3, 0 });
  ASSERT_TRUE(column);
  EXPECT_EQ(column->reason, StopReason::Complete);
  EXPECT_TRUE(column->staysIn(YLow));
  expectVector(column->direction, { 0, 0, 1 });
}

TEST(ColumnBuilder, WhereColumnsOfAFaceDisagreeThoseThatStandOnItAreLost)
{
  Columns columns(make({ 4, 4, 4 }), patches(PatchType::Symmetry), { ZLow });
  // As if one end of an edge saw a side where the other sees ground to stand on.
  for (Column& c : columns.set.columns)
  {
    if (distance(c.base, { 0, 0.5, 0 }) < 1e-12)
    {
      c.sides = { 0, 0 };
    }
  }
  EXPECT_TRUE(settleDisagreements(columns.mesh, columns.set));
  EXPECT_EQ(columns.at({ 0, 0.5, 0 })->levels, 0);
  EXPECT_EQ(columns.at({ 0, 0.25, 0 })->levels, 5);
  EXPECT_EQ(columns.at({ 0.5, 0.5, 0 })->levels, 5);
  EXPECT_FALSE(settleDisagreements(columns.mesh, columns.set));
}

TEST(ColumnBuilder, ManyThatStandOnAFaceAreLostToOneThatStaysInIt)
{
  Columns columns(make({ 4, 4, 4 }), patches(PatchType::Symmetry), { ZLow });
  for (Column& c : columns.set.columns)
  {
    if (distance(c.base, { 0.5, 0.5, 0 }) < 1e-12)
    {
      c.sides = { ZLow, 0 };
    }
  }
  EXPECT_TRUE(settleDisagreements(columns.mesh, columns.set));
  EXPECT_EQ(columns.at({ 0.5, 0.5, 0 })->levels, 5);
  EXPECT_EQ(columns.at({ 0.5, 0.25, 0 })->levels, 0);
  EXPECT_EQ(columns.at({ 0, 0, 0 })->levels, 5);
  EXPECT_FALSE(settleDisagreements(columns.mesh, columns.set));
}

TEST(ColumnBuilder, NoColumnStaysInThreeSides)
{
  const auto split = [](Side side, const Vector3& middle)
  { return side == XLow && middle.z > middle.y ? 7 : static_cast<int>(side); };
  const Columns columns(make({ 4, 4, 4 }, split), patches(PatchType::Symmetry, 7), { ZLow });
  const Column* corner = columns.at({ 0, 0, 0 });
  ASSERT_TRUE(corner);
  EXPECT_EQ(corner->levels, 0);
  EXPECT_EQ(corner->reason, StopReason::Corner);
}

TEST(ColumnBuilder, InANarrowCornerOfASideTheColumnStaysInIt)
{
  const double slope = std::tan(15 * M_PI / 180);
  const auto skew = [slope](const Vector3& p) { return Vector3{ p.x + p.z / slope, p.y, p.z }; };
  const Columns columns(make({ 4, 4, 4, skew }), patches(PatchType::Symmetry), { ZLow });
  for (const double y : { 0.0, 1.0 })
  {
    const Column* column = columns.at({ 0, y, 0 });
    ASSERT_TRUE(column);
    EXPECT_EQ(column->levels, 5);
    EXPECT_TRUE(column->staysIn(y == 0 ? YLow : YHigh));
    EXPECT_FALSE(column->staysIn(XLow));
    EXPECT_EQ(column->direction.y, 0);
  }
}

TEST(ColumnBuilder, NoColumnStandsWhereItsSideGoesOnAsTheFloor)
{
  const auto split = [](Side side, const Vector3& middle)
  { return side == ZLow && middle.y > 0.5 ? static_cast<int>(XLow) : static_cast<int>(side); };
  const Columns columns(make({ 4, 4, 4 }, split), patches(PatchType::Symmetry), { ZLow });
  const Column* atEnd = columns.at({ 0, 0.5, 0 });
  ASSERT_TRUE(atEnd);
  EXPECT_EQ(atEnd->levels, 0);
  EXPECT_EQ(atEnd->reason, StopReason::Corner);
  EXPECT_EQ(columns.at({ 0, 0.25, 0 })->levels, 5);
  EXPECT_EQ(columns.at({ 0.5, 0.5, 0 })->levels, 5);
}

TEST(ColumnBuilder, ASideRisesFromEachWallBesideIt)
{
  // The side x = 0 rises from the wall z = 0; from the wall y = 0, which ends there, by 45 and by 16 degrees.
  for (const double slope : { 1.0, 3.5 })
  {
    const auto skew = [slope](const Vector3& p) { return Vector3{ p.x - slope * p.y, p.y, p.z }; };
    const Columns columns(make({ 4, 4, 4, skew }), patches(PatchType::Symmetry), { YLow, ZLow });
    const Column* corner = columns.at({ 0, 0, 0 });
    ASSERT_TRUE(corner);
    EXPECT_EQ(corner->staysIn(XLow), slope == 1);
    EXPECT_EQ(columns.at({ 0, 0, 0.25 })->staysIn(XLow), slope == 1);
    EXPECT_TRUE(columns.at({ -slope * 0.25, 0.25, 0 })->staysIn(XLow));
  }
}

TEST(ColumnBuilder, AGridAtAWakeIsMadeOnlyWhereItIsAllowed)
{
  TetMesh mesh;
  ASSERT_TRUE(buildTetMesh(make({ 4, 4, 4 }), mesh).ok());
  PatchTable table = patches(PatchType::Symmetry);
  LayerPlan plan(7);
  for (const int wall : { XLow, ZLow })
  {
    plan[wall].firstHeight = 1e-3;
    plan[wall].numberOfLayers = 5;
  }
  EXPECT_EQ(buildColumns(mesh, BoundaryStars(mesh), table, plan, false).corners.size(), 5U);
  table[XLow].type = PatchType::Wake;
  EXPECT_EQ(buildColumns(mesh, BoundaryStars(mesh), table, plan, false).corners.size(), 0U);
  EXPECT_EQ(buildColumns(mesh, BoundaryStars(mesh), table, plan, true).corners.size(), 5U);
}

TEST(ColumnBuilder, WhereAWallBendsAlongTheRidgeThereIsNoGrid)
{
  const auto bent = [](const Vector3& p) {
    return Vector3{ p.x, p.y, p.z - 0.25 * (1 - p.z) * std::fabs(p.y - 0.5) };
  }; // by 28 degrees
  const Columns columns(make({ 4, 4, 4, bent }), patches(PatchType::Symmetry), { XLow, ZLow });
  EXPECT_EQ(columns.set.corners.size(), 4U); // of five points
  for (const TensorCorner& corner : columns.set.corners)
  {
    EXPECT_GT(std::fabs(columns.set.columns[corner.column].base.y - 0.5), 0.1);
  }
}

TEST(ColumnBuilder, WhereASideIsCurvedThereIsNoGrid)
{
  for (const double curve : { 0.0, 0.3 }) // its triangles differ by 6 degrees
  {
    const auto bent = [curve](const Vector3& p) {
      return Vector3{ p.x, p.y - curve * p.x * p.z * (1 - p.y), p.z };
    };
    const Columns columns(make({ 4, 4, 4, bent }), patches(PatchType::Symmetry), { XLow, ZLow });
    EXPECT_EQ(columns.at({ 0, 0, 0 })->hasGrid, curve == 0);
    EXPECT_TRUE(columns.at({ 0, 0.5, 0 })->hasGrid);
    EXPECT_TRUE(columns.at({ 0, 1, 0 })->hasGrid);
  }
}

#include "Layers/FaceGaps.h"

#include "Mesh/Builder.h"

#include <gtest/gtest.h>

using namespace ransmesh;

namespace
{
// One tetrahedron: a wedge between its faces 0 1 2, the floor, and 0 1 3, at the edge from 0 to 1, with columns of
// twenty levels of a hundredth on the floor's corners and on 3.
struct Wedge
{
  TetMesh mesh;
  ColumnSet set;

  explicit Wedge(double height)
  {
    MeshData data;
    data.points = { { 0, 0, 0 }, { 0, 1, 0 }, { 1, -0.5, 0 }, { 1, 1.5, height } };
    data.tetrahedra = { { 0, 2, 1, 3 } };
    data.triangles = { { 0, 1, 2 }, { 0, 3, 1 }, { 0, 2, 3 }, { 1, 3, 2 } };
    data.trianglePatch = { 1, 1, 2, 2 };
    EXPECT_TRUE(buildTetMesh(data, mesh).ok());
    LayerSpecification specification;
    specification.firstHeight = 0.01;
    specification.growthRate = 1;
    specification.numberOfLayers = 20;
    set.heights.assign(3, LayerHeights(specification));
    for (Index v = 0; v < 4; ++v)
    {
      Column c;
      c.root = c.vertex = v;
      c.base = mesh.point(v);
      c.direction = { 0, 0, v == 3 ? -1.0 : 1.0 };
      c.patch = 1;
      c.sides[0] = 2;
      c.size = 1;
      c.asked = c.levels = 20;
      set.columns.push_back(c);
      set.ofVertex.push_back(v);
    }
  }
  int levels(Index v) const { return set.columns[v].levels; }
  Index floor() const
  {
    for (std::size_t b = 0; b < mesh.boundarySlots(); ++b)
    {
      const auto v = mesh.boundaryVertices(static_cast<Index>(b));
      if (v[0] + v[1] + v[2] == 3)
      {
        return static_cast<Index>(b);
      }
    }
    throw std::logic_error("no floor");
  }
};
} // namespace

TEST(FaceGaps, TheFrontOverAPlaceStaysWithinItsShareOfTheRoom)
{
  Wedge wedge(3);
  // The middle of the floor: the mean of three equal heights.
  limitFacesMet(wedge.mesh, { { wedge.floor(), { 1.0 / 3, 1.0 / 6, 0 }, 0.2501 } }, 0.4, wedge.set);
  for (const Index v : { 0, 1, 2 })
  {
    EXPECT_EQ(wedge.levels(v), 10);
    EXPECT_EQ(wedge.set.columns[v].reason, StopReason::Gap);
  }
  EXPECT_EQ(wedge.levels(3), 20);
}

TEST(FaceGaps, WhereACornerIsLowTheOthersMayRiseMore)
{
  Wedge wedge(3);
  wedge.set.columns[0].levels = 0;
  limitFacesMet(wedge.mesh, { { wedge.floor(), { 1.0 / 3, 1.0 / 6, 0 }, 0.2501 } }, 0.4, wedge.set);
  EXPECT_EQ(wedge.levels(0), 0);
  EXPECT_EQ(wedge.levels(1), 15);
  EXPECT_EQ(wedge.levels(2), 15);
}

TEST(FaceGaps, EnoughRoomLimitsNothing)
{
  Wedge wedge(3);
  limitFacesMet(wedge.mesh, { { wedge.floor(), { 1.0 / 3, 1.0 / 6, 0 }, 0.51 } }, 0.4, wedge.set);
  EXPECT_EQ(wedge.levels(2), 20);
}

TEST(FaceGaps, InAWedgeEachFrontTurnsByItsShareOfTheAngle)
{
  // The others' corners lie far aside along the edge, so that no ray from one meets the other's face.
  Wedge wedge(0.2);
  limitInWedges(wedge.mesh, BoundaryStars(wedge.mesh), 0.3, wedge.set);
  EXPECT_EQ(wedge.levels(2), 5); // 0.3 of atan 0.2, one away from the edge: 0.0592
  EXPECT_EQ(wedge.levels(3), 6); // a little farther away: 0.0604
  EXPECT_EQ(wedge.levels(0), 20);
  EXPECT_EQ(wedge.set.columns[2].reason, StopReason::Gap);
}

TEST(FaceGaps, AWideCornerIsNoWedge)
{
  Wedge wedge(1);
  limitInWedges(wedge.mesh, BoundaryStars(wedge.mesh), 0.1, wedge.set);
  EXPECT_EQ(wedge.levels(2), 20);
  EXPECT_EQ(wedge.levels(3), 20);
}

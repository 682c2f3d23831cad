#include "Layers/ClearBall.h"

#include "Layers/ColumnBuilder.h"
#include "Mesh/Builder.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace ransmesh;
using namespace grid_mesh;

namespace
{
// A channel between two walls over the unit square, whose lid rises by the slope along x from 0.1 in the middle.
struct Channel
{
  TetMesh mesh;
  ColumnSet set;

  explicit Channel(double slope)
  {
    const auto map = [slope](const Vector3& p) {
      return Vector3{ p.x, p.y, p.z * (0.1 + slope * (p.x - 0.5)) };
    };
    EXPECT_TRUE(buildTetMesh(make({ 6, 6, 2, map }), mesh).ok());
    LayerPlan plan(7);
    plan[ZLow].firstHeight = 0.01;
    plan[ZLow].growthRate = 1;
    plan[ZLow].numberOfLayers = 5;
    plan[ZHigh] = plan[ZLow];
    set = buildColumns(mesh, BoundaryStars(mesh), patches(PatchType::Symmetry), plan);
  }
  Index at(double x, double y) const
  {
    for (const Column& c : set.columns)
    {
      if (distance(c.base, { x, y, 0 }) < 1e-9)
      {
        return c.root;
      }
    }
    throw std::logic_error("no column there");
  }
};

const Vector3 Up{ 0, 0, 1 };
} // namespace

TEST(ClearBall, BetweenParallelWallsItsDiameterIsTheGap)
{
  const Channel channel(0);
  const BoundaryStars stars(channel.mesh);
  ClearBall ball(channel.mesh, stars, channel.set);
  EXPECT_NEAR(ball.diameter(channel.at(0.5, 0.5), Up, 1), 0.1, 1e-3);
  ASSERT_NE(ball.faceTouched(), None);
  EXPECT_EQ(channel.mesh.boundaryFace(ball.faceTouched()).patch, ZHigh);
  EXPECT_NEAR(ball.placeTouched().z, 0.1, 1e-9);
}

TEST(ClearBall, UnderALidThatLeansItIsSmallerThanTheWayUp)
{
  // Touching a plane that leans by the angle a, at the height h above the root: 2 h cos a / (1 + cos a).
  const Channel channel(0.15);
  const double lean = std::atan(0.15);
  const BoundaryStars stars(channel.mesh);
  ClearBall ball(channel.mesh, stars, channel.set);
  const double expected = 0.2 * std::cos(lean) / (1 + std::cos(lean));
  EXPECT_NEAR(ball.diameter(channel.at(0.5, 0.5), Up, 1), expected, 1e-4);
}

TEST(ClearBall, NoOtherWallWithinTheWidestLeavesItAsWide)
{
  const Channel channel(0);
  const BoundaryStars stars(channel.mesh);
  ClearBall ball(channel.mesh, stars, channel.set);
  EXPECT_EQ(ball.diameter(channel.at(0.5, 0.5), Up, 0.09), 0.09);
  EXPECT_EQ(ball.faceTouched(), None);
}

TEST(WayOverWalls, FindsWhatIsJoinedWithinTheDistance)
{
  const Channel channel(0);
  const BoundaryStars stars(channel.mesh);
  Index lid = None;   // above the point that is looked from
  Index floor = None; // the last face beyond the point, on the floor
  for (std::size_t b = 0; b < channel.mesh.boundarySlots(); ++b)
  {
    const auto face = static_cast<Index>(b);
    Vector3 middle;
    for (const Index v : channel.mesh.boundaryVertices(face))
    {
      middle += (1.0 / 3) * channel.mesh.point(v);
    }
    const int patch = channel.mesh.boundaryFace(face).patch;
    lid = patch == ZHigh && distance(middle, { 1.0 / 6, 0.5, 0.1 }) < 0.13 ? face : lid;
    floor = patch == ZLow && distance(middle, { 2.0 / 6, 0.5, 0 }) < 0.13 ? face : floor;
  }
  ASSERT_NE(lid, None);
  ASSERT_NE(floor, None);
  WayOverWalls way(channel.mesh, stars);
  way.beginAt(channel.at(1.0 / 6, 0.5));
  EXPECT_TRUE(way.leadsTo(floor, 0.2));
  // One comes to the lid over the side, whose upper edge is the root of (1 / 6)^2 + 0.1^2 away.
  EXPECT_FALSE(way.leadsTo(lid, 0.1));
  EXPECT_FALSE(way.leadsTo(lid, 0.19));
  EXPECT_TRUE(way.leadsTo(lid, 0.22));
}

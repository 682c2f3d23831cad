#include "Layers/FaceRing.h"

#include "Mesh/Builder.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace ransmesh;

namespace
{
// The turn about an edge along y between a face below it and one whose normal leans by so many degrees from that
// of the first, towards x, or away from it.
Turn turnBy(double degrees)
{
  TetMesh mesh;
  EXPECT_TRUE(buildTetMesh(grid_mesh::make({ 1, 1, 1 }), mesh).ok());
  mesh.movePoint(1, { 0, 1, 0 });
  const double angle = degrees * M_PI / 180;
  FaceRing ring;
  ring.faces.resize(2);
  ring.faces[0].normal = { 0, 0, 1 };
  ring.faces[0].vertex = { 0, 2, 1 };
  ring.faces[1].normal = { std::sin(angle), 0, std::cos(angle) };
  ring.faces[1].vertex = { 0, 1, 3 };
  return ring.turnAfter({ 0, 0, 0 }, mesh, 0);
}
} // namespace

TEST(FaceRing, TellsWhichWayFacesTurn)
{
  for (const double angle : { 20.0, 90.0, 170.0 })
  {
    EXPECT_NEAR(turnBy(angle).angle, angle * M_PI / 180, 1e-9);
    EXPECT_NEAR(turnBy(-angle).angle, angle * M_PI / 180, 1e-9);
    EXPECT_NE(turnBy(angle).isConvex, turnBy(-angle).isConvex);
  }
}

TEST(FaceRing, FacesFoldedOntoEachOtherHaveTheFluidAllAround)
{
  EXPECT_TRUE(turnBy(180).isConvex);
  EXPECT_TRUE(turnBy(-180).isConvex);
}

#include "Removal/SurfaceMemory.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace ransmesh;

namespace
{
// A line of edges of a ridge, from which points are taken one after the other.
struct Line
{
  TetMesh mesh;
  Index first = 0;
  Index second = 1;

  // Chords of the unit circle, so many degrees long; straight if 0.
  explicit Line(double degrees)
  {
    constexpr int count = 50;
    for (int i = 0; i < count; ++i)
    {
      const double angle = i * degrees * M_PI / 180;
      mesh.addVertex(degrees > 0 ? Vector3{ std::cos(angle), std::sin(angle), 0 } : Vector3{ 0.1 * i, 0, 0 });
    }
  }

  // Takes out the second point, which may then lie so far away.
  bool takeSecond(SurfaceMemory& memory, double allowed)
  {
    const Index next = second + 1;
    const SurfaceMemory::Piece old[] = { { first, second, second }, { second, next, next } };
    const SurfaceMemory::Piece edge{ first, next, next };
    if (!memory.allows(old, { &edge, 1 }, { &mesh.point(second), 1 }, allowed, first))
    {
      return false;
    }
    memory.remember();
    second = next;
    return true;
  }
};
} // namespace

TEST(SurfaceMemory, ChangesDoNotAddUp)
{
  // The points are 2.4e-3 from the chord over two steps of four degrees, 4.9e-3 from that over three.
  Line line(4);
  SurfaceMemory memory(line.mesh);
  EXPECT_TRUE(line.takeSecond(memory, 6e-3));
  EXPECT_TRUE(line.takeSecond(memory, 6e-3));
  EXPECT_FALSE(line.takeSecond(memory, 6e-3));
}

TEST(SurfaceMemory, PointsLostBeforeKeepTheirOwnAllowance)
{
  Line line(4);
  SurfaceMemory memory(line.mesh);
  EXPECT_TRUE(line.takeSecond(memory, 3e-3));
  EXPECT_FALSE(line.takeSecond(memory, 1));
}

TEST(SurfaceMemory, StraightLinesLoseAllTheirPoints)
{
  Line line(0);
  SurfaceMemory memory(line.mesh);
  for (int i = 0; i < 48; ++i)
  {
    EXPECT_TRUE(line.takeSecond(memory, 1e-6));
  }
}

TEST(SurfaceMemory, WhatLiesBesideThePiecesIsNotAsked)
{
  // What the eighth point holds was lost behind it; the pieces before it are judged alone.
  Line line(4);
  SurfaceMemory memory(line.mesh);
  line.first = 8;
  line.second = 9;
  EXPECT_TRUE(line.takeSecond(memory, 3e-3));
  line.first = 6;
  line.second = 7;
  EXPECT_TRUE(line.takeSecond(memory, 3e-3));
}

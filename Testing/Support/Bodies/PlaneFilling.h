// Triangles of graded size that fill a plane region between given loops.
#pragma once

#include <array>
#include <vector>

namespace bodies
{
struct PlanePoint
{
  double x = 0;
  double y = 0;
};
using Loop = std::vector<PlanePoint>;

struct PlaneTriangles
{
  std::vector<PlanePoint> points; // those of the loops first, in their order
  std::vector<std::array<int, 3>> triangles;
};

// The region is what an odd number of loops goes around. The loops' edges are kept; inside, the edges are as
// long as those of the nearest loop, and `growth` more for each length further away.
PlaneTriangles fillPlane(const std::vector<Loop>& loops, double growth);

// n points of the line from a to b, with a, without b.
void appendLine(Loop& loop, const PlanePoint& a, const PlanePoint& b, int n);
} // namespace bodies

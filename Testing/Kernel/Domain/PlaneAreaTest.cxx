#include "Domain/PlaneArea.h"

#include <gtest/gtest.h>

#include <utility>

namespace
{
using namespace ransmesh;

// Squares across z = 1, from `low` to `high` in x and y.
struct Squares
{
  std::vector<Vector3> points;

  std::vector<std::array<Index, 2>> add(double low, double high)
  {
    const auto first = static_cast<Index>(points.size());
    for (const auto& [x, y] : { std::pair{ low, low }, { high, low }, { high, high }, { low, high } })
    {
      points.push_back({ x, y, 1 });
    }
    return { { first, first + 1 }, { first + 1, first + 2 }, { first + 2, first + 3 }, { first + 3, first } };
  }
};

void append(const std::vector<std::array<Index, 2>>& more, std::vector<std::array<Index, 2>>& edges)
{
  edges.insert(edges.end(), more.begin(), more.end());
}

TEST(PlaneArea, HasAHoleInEveryOtherLoop)
{
  Squares squares;
  PlaneEdges edges;
  append(squares.add(0, 10), edges.borders);
  append(squares.add(2, 8), edges.borders);
  append(squares.add(4, 6), edges.borders);
  PlaneArea area;
  ASSERT_TRUE(findPlaneArea(squares.points, 2, edges, std::nullopt, area).ok());
  EXPECT_EQ(area.edges.size(), 12u);
  ASSERT_EQ(area.holes.size(), 1u);
  const Vector3& hole = area.holes[0];
  EXPECT_EQ(hole.z, 1);
  const double most = std::max(std::fabs(hole.x - 5), std::fabs(hole.y - 5));
  EXPECT_GT(most, 1);
  EXPECT_LT(most, 3);
}

TEST(PlaneArea, LiesInTheOutlineOnTheSideOfTheSeed)
{
  Squares squares;
  PlaneEdges edges;
  append(squares.add(0, 10), edges.outline);
  append(squares.add(2, 8), edges.borders);
  PlaneArea area;
  ASSERT_TRUE(findPlaneArea(squares.points, 2, edges, 0, area).ok());
  EXPECT_EQ(area.edges.size(), 8u);
  EXPECT_EQ(area.holes.size(), 1u);
}

TEST(PlaneArea, EndsWhereABorderMeetsTheOutline)
{
  // The border cuts the corner (10, 10) off.
  Squares squares;
  PlaneEdges edges;
  squares.points = { { 0, 0, 1 }, { 10, 0, 1 }, { 10, 5, 1 }, { 10, 10, 1 }, { 5, 10, 1 }, { 0, 10, 1 } };
  edges.outline = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 4 }, { 4, 5 }, { 5, 0 } };
  edges.borders = { { 2, 4 } };
  PlaneArea area;
  ASSERT_TRUE(findPlaneArea(squares.points, 2, edges, 0, area).ok());
  EXPECT_EQ(area.edges.size(), 5u) << "all but the two at the corner";
}

TEST(PlaneArea, KeepsEdgesInsideAndLeavesOutThoseInHoles)
{
  Squares squares;
  PlaneEdges edges;
  append(squares.add(0, 10), edges.borders);
  append(squares.add(4, 6), edges.borders);
  squares.points.insert(squares.points.end(), { { 1, 1, 1 }, { 2, 2, 1 }, { 4.5, 4.5, 1 }, { 5, 5, 1 } });
  edges.inside = { { 8, 9 }, { 10, 11 } };
  PlaneArea area;
  ASSERT_TRUE(findPlaneArea(squares.points, 2, edges, std::nullopt, area).ok());
  EXPECT_EQ(area.edges.size(), 9u);
}

TEST(PlaneArea, RefusesEdgesThatCrossOrDoNotClose)
{
  Squares squares;
  PlaneEdges edges;
  append(squares.add(0, 2), edges.borders);
  append(squares.add(1, 3), edges.borders);
  PlaneArea area;
  EXPECT_FALSE(findPlaneArea(squares.points, 2, edges, std::nullopt, area).ok());
  PlaneEdges open;
  open.borders = { { 0, 1 }, { 1, 2 }, { 2, 3 } };
  EXPECT_FALSE(findPlaneArea(squares.points, 2, open, std::nullopt, area).ok());
  EXPECT_FALSE(findPlaneArea(squares.points, 2, {}, std::nullopt, area).ok());
}
} // namespace

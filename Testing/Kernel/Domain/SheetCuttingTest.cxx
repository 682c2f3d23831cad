#include "Domain/SheetCutting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using namespace ransmesh;

// The square [0, 1] x [0, 1] in the plane z = slope * x, in so many patches one beside the other along y.
SurfaceMesh square(int cells, double slope, int patches = 1)
{
  SurfaceMesh sheet;
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      const double x = static_cast<double>(i) / cells;
      sheet.points.push_back({ x, static_cast<double>(j) / cells, slope * x });
    }
  }
  for (int j = 0; j < cells; ++j)
  {
    for (int i = 0; i < cells; ++i)
    {
      const Index v = j * (cells + 1) + i;
      sheet.triangles.push_back({ v, v + 1, v + cells + 2 });
      sheet.triangles.push_back({ v, v + cells + 2, v + cells + 1 });
      sheet.patch.insert(sheet.patch.end(), 2, 1 + j * patches / cells);
    }
  }
  return sheet;
}

Vector3 doubleArea(const SurfaceMesh& sheet, std::size_t t)
{
  const auto& v = sheet.triangles[t];
  const Vector3& a = sheet.points[v[0]];
  return cross(sheet.points[v[1]] - a, sheet.points[v[2]] - a);
}

// Shortest altitude over longest side, of the worst triangle.
double worstShape(const SurfaceMesh& sheet)
{
  double worst = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < sheet.triangles.size(); ++t)
  {
    double longest = 0;
    for (int i = 0; i < 3; ++i)
    {
      longest = std::max(longest,
        distance(sheet.points[sheet.triangles[t][i]], sheet.points[sheet.triangles[t][(i + 1) % 3]]));
    }
    worst = std::min(worst, norm(doubleArea(sheet, t)) / (longest * longest));
  }
  return worst;
}

void expectCut(SurfaceMesh sheet, const Extent& box, double area)
{
  const Vector3 normal = normalized(doubleArea(sheet, 0));
  EXPECT_GT(cutByBox(sheet, box, 1e-9), 0u);
  ASSERT_EQ(sheet.patch.size(), sheet.triangles.size());
  double sum = 0;
  for (std::size_t t = 0; t < sheet.triangles.size(); ++t)
  {
    const Vector3 n = doubleArea(sheet, t);
    sum += norm(n) / 2;
    EXPECT_GT(dot(n, normal), 0) << t;
    for (const Index v : sheet.triangles[t])
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_GE(sheet.points[v][axis], box.low[axis]);
        EXPECT_LE(sheet.points[v][axis], box.high[axis]);
      }
    }
  }
  EXPECT_NEAR(sum, area, 1e-12);
  EXPECT_GT(worstShape(sheet), 0.15);
}

TEST(SheetCutting, WhatLiesInsideStays)
{
  SurfaceMesh sheet = square(5, 0.5);
  const auto triangles = sheet.triangles;
  EXPECT_EQ(cutByBox(sheet, { { -1, -1, -1 }, { 2, 2, 2 } }, 1e-9), 0u);
  EXPECT_EQ(sheet.triangles, triangles);
}

TEST(SheetCutting, TheBorderLiesInTheSide)
{
  for (int i = 1; i < 40; ++i)
  {
    const double x = 0.3 + 0.015 * i;
    expectCut(square(6, 0.5, 2), { { -1, -1, -1 }, { x, 2, 2 } }, x * std::sqrt(1.25));
    expectCut(square(6, 0.5, 2), { { x, -1, -1 }, { 2, 2, 2 } }, (1 - x) * std::sqrt(1.25));
    expectCut(square(6, 0.5, 2), { { -1, -1, -1 }, { 2, 2, x / 2 } }, x * std::sqrt(1.25));
  }
}

TEST(SheetCutting, SeveralSidesCut)
{
  expectCut(square(7, 0), { { 0.22, 0.31, -1 }, { 0.83, 0.64, 1 } }, 0.61 * 0.33);
}

TEST(SheetCutting, NothingIsLeftOfASheetOutside)
{
  SurfaceMesh sheet = square(3, 0);
  EXPECT_EQ(cutByBox(sheet, { { 2, 2, 2 }, { 3, 3, 3 } }, 1e-9), 18u);
  EXPECT_TRUE(sheet.triangles.empty());
}
} // namespace

#include "Geometry/TetrahedronMeasures.h"

#include <gtest/gtest.h>

#include <random>

namespace
{
using ransmesh::Vector3;

const Vector3 A{ 1, 1, 1 };
const Vector3 B{ -1, -1, 1 };
const Vector3 C{ 1, -1, -1 };
const Vector3 D{ -1, 1, -1 };

TEST(TetrahedronMeasures, regularOneIsTheUnit)
{
  ASSERT_GT(ransmesh::orientation(A, C, B, D), 0);
  const auto m = ransmesh::measure(A, C, B, D);
  EXPECT_NEAR(m.quality, 1, 1e-14);
  EXPECT_NEAR(m.volume, 8.0 / 3, 1e-14);
  EXPECT_NEAR(m.longestEdge, std::sqrt(8.0), 1e-14);
  EXPECT_NEAR(m.shortestEdge, std::sqrt(8.0), 1e-14);
  EXPECT_NEAR(m.largestDihedral, std::acos(1.0 / 3) * 180 / M_PI, 1e-12);
  EXPECT_NEAR(m.smallestDihedral, m.largestDihedral, 1e-12);
  EXPECT_NEAR(m.stretching(), std::sqrt(1.5), 1e-14);
}

TEST(TetrahedronMeasures, qualityHasTheSignOfTheExactVolume)
{
  EXPECT_LT(ransmesh::quality(A, B, C, D), 0);
  // Exactly flat, though no coordinate is a round number.
  const Vector3 p{ 0.1, 0.2, 0.3 };
  const Vector3 q{ 0.7, 0.2, 0.3 };
  const Vector3 r{ 0.1, 0.9, 0.3 };
  EXPECT_LE(ransmesh::quality(p, q, r, { 0.33, 0.44, 0.3 }), 0);
  // One unit in the last place above the plane.
  EXPECT_GT(ransmesh::quality(p, q, r, { 0.33, 0.44, std::nextafter(0.3, 1) }), 0);
  EXPECT_LE(ransmesh::quality(p, q, r, { 0.33, 0.44, std::nextafter(0.3, 0) }), 0);
  EXPECT_EQ(ransmesh::quality(p, p, p, p), 0);
}

// A prism's three kinds of tetrahedra on a triangle with legs 1, at ever smaller heights.
TEST(TetrahedronMeasures, anglesOfFlatTetrahedraAreSound)
{
  for (double h = 1; h > 1e-13; h /= 10)
  {
    const auto low = ransmesh::dihedralAngles({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, h });
    EXPECT_NEAR(low[0], 90, 1e-10) << h; // edge 01
    EXPECT_NEAR(low[1], 90, 1e-10) << h; // edge 02
    EXPECT_NEAR(low[2], 90, 1e-10) << h; // edge 03
    const double atHypotenuse = std::atan2(h, std::sqrt(0.5)) * 180 / M_PI;
    EXPECT_NEAR(low[3] / atHypotenuse, 1, 1e-10) << h;
    // The apex above the middle of the triangle: three angles near 180 are there to be seen.
    const auto flat = ransmesh::dihedralAngles({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.25, 0.25, h });
    EXPECT_NEAR(flat[0], std::atan2(h, 0.25) * 180 / M_PI, 1e-10) << h;
    EXPECT_GT(flat[2], 90) << h;
  }
}

TEST(TetrahedronMeasures, smallHeightsAtLargeCoordinatesKeepTheirAngles)
{
  const Vector3 shift{ 1, 1, 1 };
  const double h = std::ldexp(1.0, -27); // about 7e-9, exact at these coordinates
  const auto m = ransmesh::measure(
    shift, shift + Vector3{ 1, 0, 0 }, shift + Vector3{ 0, 1, 0 }, shift + Vector3{ 0, 0, h });
  EXPECT_NEAR(m.largestDihedral, 90, 1e-9);
  EXPECT_NEAR(m.stretching(), std::sqrt(2.0) / h * std::sqrt(1 + 2 * h * h), 1);
  EXPECT_NEAR(m.volume, h / 6, 1e-22);
}

TEST(TetrahedronMeasures, aFlatOneHasFiniteMeasures)
{
  const auto m = ransmesh::measure({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 });
  EXPECT_EQ(m.volume, 0);
  EXPECT_TRUE(std::isfinite(m.stretching()));
  EXPECT_DOUBLE_EQ(m.largestDihedral, 180);
  EXPECT_DOUBLE_EQ(m.smallestDihedral, 0);
}

// Against the direct way, by the faces' normals, on well-shaped tetrahedra.
TEST(TetrahedronMeasures, anglesAgreeWithNormals)
{
  const std::array<Vector3, 4> p = { Vector3{ 0.1, -0.3, 0.2 }, { 1.2, 0.1, -0.1 }, { 0.3, 1.1, 0.4 },
    { 0.2, 0.3, 0.9 } };
  constexpr int faces[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
  std::array<Vector3, 4> normal;
  for (int f = 0; f < 4; ++f)
  {
    normal[f] = normalized(cross(p[faces[f][1]] - p[faces[f][0]], p[faces[f][2]] - p[faces[f][0]]));
  }
  const auto angles = ransmesh::dihedralAngles(p[0], p[1], p[2], p[3]);
  for (int e = 0; e < 6; ++e)
  {
    const int i =
      ransmesh::EdgeCorners[5 - e][0]; // the faces at an edge are those opposite to its other corners
    const int j = ransmesh::EdgeCorners[5 - e][1];
    EXPECT_NEAR(angles[e], std::acos(-dot(normal[i], normal[j])) * 180 / M_PI, 1e-10);
  }
}
} // namespace

TEST(TetrahedronMeasures, angleQualityCountsFlatCapsAsBad)
{
  using ransmesh::angleQuality;
  // The largest cosine between normals of the regular one's faces is -1/3.
  EXPECT_NEAR(angleQuality({ 1, 1, 1 }, { -1, 1, -1 }, { 1, -1, -1 }, { -1, -1, 1 }), 4.0 / 3, 1e-12);
  // A needle has no large angle: quality decides.
  const double needle = ransmesh::quality({ 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 0.9, 0 }, { 0.5, 0.3, 20 });
  EXPECT_NEAR(angleQuality({ 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 0.9, 0 }, { 0.5, 0.3, 20 }), 4 * needle, 1e-12);
  // Two triangles that meet in the edge a b and turn by 2 atan(h) there.
  const auto cap = [](double h, auto measure) {
    return measure({ 0, 1, 0 }, { 0, -1, 0 }, { 1, 0, h }, { -1, 0, h }, ransmesh::ShapeRange{});
  };
  const double h = std::tan(2.5 * 3.14159265358979 / 180);
  EXPECT_NEAR(cap(h, angleQuality), 1 + std::cos(175 * 3.14159265358979 / 180), 1e-9);
  EXPECT_GT(cap(h, ransmesh::plainQuality), 0.05);
  // A tetrahedron that is not positive stays so.
  EXPECT_LE(angleQuality({ 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, 1 }), 0);
}

TEST(TetrahedronMeasures, angleQualityIsExactWithinTheRangeAskedFor)
{
  std::mt19937 random(20261123);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::uniform_real_distribution<double> limit(0, 1);
  const auto point = [&] { return Vector3{ coordinate(random), coordinate(random), coordinate(random) }; };
  for (int i = 0; i < 200'000; ++i)
  {
    const std::array<Vector3, 4> p = { point(), point(), point(), point() };
    const double low = limit(random);
    const double high = limit(random);
    const ransmesh::ShapeRange range{ std::min(low, high), std::max(low, high) };
    const double exact = ransmesh::angleQuality(p[0], p[1], p[2], p[3]);
    const double given = ransmesh::angleQuality(p[0], p[1], p[2], p[3], range);
    ASSERT_EQ(given > range.floor, exact > range.floor);
    ASSERT_EQ(given > range.ceiling, exact > range.ceiling);
    if (exact > range.floor && exact <= range.ceiling)
    {
      ASSERT_EQ(given, exact);
    }
  }
}

#include "Geometry/Predicates.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace
{
using namespace ransmesh;

TEST(Orientation, isPositiveInVtksSense)
{
  EXPECT_EQ(orientation({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }), 1);
  EXPECT_EQ(orientation({ 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, 1 }), -1);
  EXPECT_TRUE(isPositive({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }));
  EXPECT_NEAR(sixVolumes({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }), 1, 1e-15);
}

TEST(Orientation, tiesAreExact)
{
  const Vector3 a{ 0.1, 0.2, 0.3 };
  const Vector3 b{ 0.7, 0.9, 0.3 };
  const Vector3 c{ 0.4, -0.8, 0.3 };
  EXPECT_EQ(orientation(a, b, c, { 1.0 / 3, 2.0 / 3, 0.3 }), 0); // all in one plane of constant z
  EXPECT_EQ(orientation(a, b, c, a), 0);
  EXPECT_EQ(orientation(a, a, a, a), 0);
  const Vector3 onDiagonal[4] = { { 0.1, 0.1, 0 }, { 0.7, 0.7, 1 }, { 0.3, 0.3, 5 }, { 1e-9, 1e-9, 0.2 } };
  EXPECT_EQ(orientation(onDiagonal[0], onDiagonal[1], onDiagonal[2], onDiagonal[3]), 0); // the plane x = y
}

// One unit in the last place decides, at any size of the coordinates.
TEST(Orientation, seesTheLastBit)
{
  for (const double z : { 1e-300, 1e-8, 0.3, 1.0, 1e8, 1e100 })
  {
    const Vector3 a{ 0.1, 0.2, z };
    const Vector3 b{ 0.7, 0.9, z };
    const Vector3 c{ 0.4, -0.8, z };
    const int above = orientation(a, b, c, { 0.5, 0.1, std::nextafter(z, 1e200) });
    const int below = orientation(a, b, c, { 0.5, 0.1, std::nextafter(z, 0) });
    EXPECT_EQ(above, -below) << z;
    EXPECT_NE(above, 0) << z;
  }
}

TEST(Orientation, thinPrismsOverSkewPlanes)
{
  // A triangle that lies in no plane of the axes, and apexes 1e-8 and less above and below it.
  const Vector3 a{ 0.12, 0.34, 0.56 };
  const Vector3 b{ 1.21, 0.43, 0.65 };
  const Vector3 c{ 0.31, 1.37, 0.91 };
  const Vector3 n = normalized(cross(b - a, c - a));
  for (double h = 1e-8; h > 1e-14; h /= 10)
  {
    const Vector3 foot = (1.0 / 3) * (a + b + c);
    EXPECT_EQ(orientation(a, b, c, foot + h * n), 1) << h;
    EXPECT_EQ(orientation(a, b, c, foot + (-h) * n), -1) << h;
  }
}

TEST(Orientation, isAntisymmetricAlsoWhereRoundingDecidesNothing)
{
  std::mt19937 random(7);
  std::uniform_int_distribution<int> grid(0, 3); // many exact ties
  for (int i = 0; i < 20000; ++i)
  {
    std::array<Vector3, 4> p;
    for (Vector3& q : p)
    {
      q = { 0.1 * grid(random), 0.1 * grid(random), 0.1 * grid(random) };
    }
    const int sign = orientation(p[0], p[1], p[2], p[3]);
    EXPECT_EQ(orientation(p[1], p[0], p[2], p[3]), -sign);
    EXPECT_EQ(orientation(p[1], p[2], p[0], p[3]), sign);
    EXPECT_EQ(orientation(p[3], p[2], p[1], p[0]), sign);
    EXPECT_EQ(orientation(p[1], p[2], p[3], p[0]), -sign);
  }
}

// Integer coordinates have an exact determinant to compare with.
TEST(Orientation, agreesWithIntegers)
{
  std::mt19937 random(11);
  std::uniform_int_distribution<long> coordinate(-50, 50);
  for (int i = 0; i < 20000; ++i)
  {
    long d[4][3];
    std::array<Vector3, 4> p;
    for (int j = 0; j < 4; ++j)
    {
      for (int k = 0; k < 3; ++k)
      {
        d[j][k] = coordinate(random);
        p[j][k] = static_cast<double>(d[j][k]);
      }
    }
    const auto e = [&d](int j, int k) { return d[j][k] - d[0][k]; };
    const long volume = e(3, 0) * (e(1, 1) * e(2, 2) - e(1, 2) * e(2, 1)) +
      e(3, 1) * (e(1, 2) * e(2, 0) - e(1, 0) * e(2, 2)) + e(3, 2) * (e(1, 0) * e(2, 1) - e(1, 1) * e(2, 0));
    EXPECT_EQ(orientation(p[0], p[1], p[2], p[3]), (volume > 0) - (volume < 0));
  }
}

TEST(InSphere, insideOnAndOutside)
{
  const Vector3 a{ 0, 0, 0 };
  const Vector3 b{ 1, 0, 0 };
  const Vector3 c{ 0, 1, 0 };
  const Vector3 d{ 0, 0, 1 };
  EXPECT_EQ(inSphere(a, b, c, d, { 0.5, 0.5, 0.5 }), 1);
  EXPECT_EQ(inSphere(a, b, c, d, { 1, 1, 1 }), 0); // the cube's far corner, exactly
  EXPECT_EQ(inSphere(a, b, c, d, { 1, 1, 0 }), 0);
  EXPECT_EQ(inSphere(a, b, c, d, { 1, 1, std::nextafter(1.0, 2) }), -1);
  EXPECT_EQ(inSphere(a, b, c, d, { 1, 1, std::nextafter(1.0, 0) }), 1);
  EXPECT_EQ(inSphere(a, b, c, d, { 2, 2, 2 }), -1);
}

TEST(InSphere, prismsOfALayerAreCospherical)
{
  // The six points of a right prism lie on one sphere, however thin it is.
  const double h = std::ldexp(1.0, -27);
  const Vector3 a{ 0, 0, 0 };
  const Vector3 b{ 1, 0, 0 };
  const Vector3 c{ 0, 1, 0 };
  const Vector3 top{ 0, 0, h };
  EXPECT_EQ(inSphere(a, b, c, top, { 1, 0, h }), 0);
  EXPECT_EQ(inSphere(a, b, c, top, { 0, 1, h }), 0);
}

TEST(Vector3, arithmetic)
{
  const Vector3 a{ 1, 2, 3 };
  const Vector3 b{ -2, 0.5, 4 };
  EXPECT_EQ(a + b, (Vector3{ -1, 2.5, 7 }));
  EXPECT_EQ(a - b, (Vector3{ 3, 1.5, -1 }));
  EXPECT_EQ(2 * a, (Vector3{ 2, 4, 6 }));
  EXPECT_EQ(dot(a, b), 11);
  EXPECT_EQ(cross({ 1, 0, 0 }, { 0, 1, 0 }), (Vector3{ 0, 0, 1 }));
  EXPECT_EQ(dot(cross(a, b), a), 0);
  EXPECT_EQ(norm({ 3, 4, 12 }), 13);
  EXPECT_EQ(distance(a, a), 0);
  EXPECT_EQ(a[0] + 10 * a[1] + 100 * a[2], 321);
  Vector3 sum = a;
  sum += b;
  EXPECT_EQ(sum, a + b);
  sum[1] = 9;
  EXPECT_EQ(sum.y, 9);
}

TEST(Vector3, normalizedKeepsZero)
{
  EXPECT_NEAR(norm(normalized({ 1e-9, 2e-9, -3e-9 })), 1, 1e-15);
  EXPECT_EQ(normalized({ 0, 0, 0 }), (Vector3{ 0, 0, 0 }));
}

TEST(Vector3, finite)
{
  EXPECT_TRUE(isFinite({ 1e300, -1e300, 0 }));
  EXPECT_FALSE(isFinite({ 0, NAN, 0 }));
  EXPECT_FALSE(isFinite({ 0, 0, INFINITY }));
}
} // namespace

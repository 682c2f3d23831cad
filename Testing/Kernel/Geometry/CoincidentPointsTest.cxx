#include "Geometry/CoincidentPoints.h"

#include <gtest/gtest.h>

namespace
{
using namespace ransmesh;
using Numbers = std::vector<std::int32_t>;

TEST(CoincidentPoints, AreThoseThatRepeatAnEarlierOne)
{
  EXPECT_EQ(findCoincident({ { 1, 2, 3 }, { 3, 2, 1 }, { 1, 2, 3 }, { 1, 2, 3 }, { 3, 2, 1 } }),
    (Numbers{ 2, 3, 4 }));
}

TEST(CoincidentPoints, AreNoneAmongDifferentOnes)
{
  EXPECT_TRUE(findCoincident({}).empty());
  EXPECT_TRUE(findCoincident({ { 0, 0, 0 }, { 0, 0, 1e-300 }, { 0, 1e-300, 0 } }).empty());
}

TEST(CoincidentPoints, TakesBothZerosForOne)
{
  EXPECT_EQ(findCoincident({ { 0.0, 1, -0.0 }, { -0.0, 1, 0.0 } }), Numbers{ 1 });
}

TEST(CoincidentPoints, AreFoundAmongManyOnALattice)
{
  std::vector<Vector3> points;
  for (int i = 0; i < 30; ++i)
  {
    for (int j = 0; j < 30; ++j)
    {
      points.push_back({ 1.0 * i, 1.0 * j, 0.5 });
    }
  }
  EXPECT_TRUE(findCoincident(points).empty());
  points.push_back(points[77]);
  EXPECT_EQ(findCoincident(points), Numbers{ 900 });
}
} // namespace

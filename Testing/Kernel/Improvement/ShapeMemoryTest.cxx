#include "Improvement/ShapeMemory.h"

#include <gtest/gtest.h>

namespace
{
using ransmesh::Index;
using ransmesh::ShapeMemory;

constexpr double NoCeiling = 2;
constexpr Index SamePlace = 1 << 20; // apart from 0 by whole tables

class ShapeMemoryTest : public testing::Test
{
protected:
  // Whether the memory had to ask.
  bool asks(Index tet, double ceiling, double answer)
  {
    bool asked = false;
    given_ = memory_.of(tet, ceiling,
      [&]
      {
        asked = true;
        return answer;
      });
    return asked;
  }

  ShapeMemory memory_;
  double given_ = 0;
};

TEST_F(ShapeMemoryTest, remembersUntilToldToForget)
{
  EXPECT_TRUE(asks(0, NoCeiling, 0.3));
  EXPECT_FALSE(asks(0, NoCeiling, 0.7));
  EXPECT_EQ(given_, 0.3);
  memory_.forget(0);
  EXPECT_TRUE(asks(0, NoCeiling, 0.7));
  memory_.forgetAll();
  EXPECT_TRUE(asks(0, NoCeiling, 0.9));
  EXPECT_EQ(given_, 0.9);
}

TEST_F(ShapeMemoryTest, tetrahedraAtOnePlaceTakeTurns)
{
  asks(0, NoCeiling, 0.3);
  memory_.forget(SamePlace);
  EXPECT_FALSE(asks(0, NoCeiling, 0.4));
  EXPECT_TRUE(asks(SamePlace, NoCeiling, 0.5));
  EXPECT_TRUE(asks(0, NoCeiling, 0.3));
}

TEST_F(ShapeMemoryTest, whatWasAboveTheCeilingIsAskedForAgainAboveIt)
{
  asks(0, 0.2, 0.3);
  EXPECT_FALSE(asks(0, 0.2, 0.8)); // above it still
  EXPECT_FALSE(asks(0, 0.1, 0.8));
  EXPECT_TRUE(asks(0, 0.25, 0.8)); // 0.3 said only: above 0.2
  EXPECT_EQ(given_, 0.8);
  asks(1, 0.2, 0.15);
  EXPECT_FALSE(asks(1, 0.5, 0.8)); // below the ceiling it was exact
  EXPECT_EQ(given_, 0.15);
}
} // namespace

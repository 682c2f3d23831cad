#include "Support/WorkRounds.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{
using Numbers = std::vector<std::size_t>;

class WorkRoundsTest : public testing::Test
{
protected:
  // One round; asks for a number again when it comes to another one.
  Numbers round(std::size_t when = None, std::size_t again = None)
  {
    Numbers seen;
    work_.runRound(
      [&](std::size_t i)
      {
        seen.push_back(i);
        if (i == when)
        {
          work_.addAgain(again);
        }
      });
    return seen;
  }

  static constexpr std::size_t None = ~std::size_t{ 0 };
  ransmesh::WorkRounds work_;
};

TEST_F(WorkRoundsTest, eachThingOnceInOrder)
{
  work_.clear(200);
  for (const std::size_t i : { 199, 64, 0, 63, 64, 128 })
  {
    work_.add(i);
  }
  EXPECT_EQ(round(), (Numbers{ 0, 63, 64, 128, 199 }));
  EXPECT_EQ(round(), Numbers{});
}

TEST_F(WorkRoundsTest, whatIsToComeComesInThisRoundAndTheNext)
{
  work_.clear(200);
  work_.add(10);
  EXPECT_EQ(round(10, 11), (Numbers{ 10, 11 }));
  EXPECT_EQ(round(), Numbers{ 11 });
  EXPECT_EQ(round(), Numbers{});
}

TEST_F(WorkRoundsTest, whatIsPastComesInTheNextRoundOnly)
{
  work_.clear(200);
  work_.add(10);
  work_.add(100);
  EXPECT_EQ(round(100, 10), (Numbers{ 10, 100 }));
  EXPECT_EQ(round(10, 10), Numbers{ 10 });
  EXPECT_EQ(round(), Numbers{ 10 });
  EXPECT_EQ(round(), Numbers{});
}

TEST_F(WorkRoundsTest, clearingForgets)
{
  work_.clear(200);
  work_.add(10);
  work_.addAgain(20);
  work_.clear(100);
  EXPECT_EQ(round(), Numbers{});
  EXPECT_EQ(round(), Numbers{});
}
} // namespace

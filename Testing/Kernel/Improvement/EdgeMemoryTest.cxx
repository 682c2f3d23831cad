#include "Improvement/EdgeMemory.h"

#include <gtest/gtest.h>

namespace
{
using namespace ransmesh;

TEST(EdgeMemory, KnowsEdgesEitherWayRound)
{
  EdgeMemory memory;
  EXPECT_EQ(memory.triedAt(3, 8), 0U);
  memory.note(8, 3, 5);
  EXPECT_EQ(memory.triedAt(3, 8), 5U);
  EXPECT_EQ(memory.triedAt(8, 3), 5U);
  EXPECT_EQ(memory.triedAt(3, 9), 0U);
}

TEST(EdgeMemory, ForgetsButNeverMistakesOneEdgeForAnother)
{
  EdgeMemory memory;
  constexpr Index count = 20'000; // more than there is room for
  for (Index i = 0; i < count; ++i)
  {
    memory.note(i, i + 1, static_cast<std::uint32_t>(i) + 1);
  }
  std::size_t known = 0;
  for (Index i = 0; i < count; ++i)
  {
    const std::uint32_t at = memory.triedAt(i + 1, i);
    EXPECT_TRUE(at == 0 || at == static_cast<std::uint32_t>(i) + 1);
    known += at != 0;
  }
  EXPECT_GT(known, 0U);
  EXPECT_LT(known, static_cast<std::size_t>(count));
}
} // namespace

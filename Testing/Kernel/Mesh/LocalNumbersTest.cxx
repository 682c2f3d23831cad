#include "Mesh/LocalNumbers.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace
{
TEST(LocalMarks, hasWhatWasMarkedSinceItWasCleared)
{
  std::mt19937 random(3);
  std::uniform_int_distribution<ransmesh::Index> number(0, 2'000'000);
  ransmesh::LocalMarks marks;
  for (const int count : { 10, 5000, 100 }) // it grows, and is used again
  {
    marks.clear();
    std::set<ransmesh::Index> marked;
    for (int i = 0; i < count; ++i)
    {
      const ransmesh::Index n = number(random);
      EXPECT_EQ(marks.set(n), marked.insert(n).second);
      EXPECT_FALSE(marks.set(n));
    }
    for (int i = 0; i < 20'000; ++i)
    {
      const ransmesh::Index n = number(random);
      EXPECT_EQ(marks.test(n), marked.contains(n));
    }
    for (const ransmesh::Index n : marked)
    {
      EXPECT_TRUE(marks.test(n));
    }
  }
}

TEST(LocalNumbers, areGivenInOrder)
{
  ransmesh::LocalNumbers numbers;
  for (int round = 0; round < 2; ++round)
  {
    numbers.clear();
    EXPECT_FALSE(numbers.has(70));
    for (int i = 0; i < 2000; ++i) // it grows on the way
    {
      EXPECT_EQ(numbers.add(7 * i + round), i);
    }
    EXPECT_EQ(numbers.add(70 + round), 10);
    EXPECT_TRUE(numbers.has(70 + round));
    EXPECT_FALSE(numbers.has(71 + round));
    EXPECT_EQ(numbers.count(), 2000);
  }
}
} // namespace

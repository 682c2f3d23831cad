#include "Support/Scratch.h"

#include <gtest/gtest.h>

#include <vector>

TEST(Scratch, KeepsWhatWasAddedSinceItWasCleared)
{
  ransmesh::Scratch<int> list;
  for (const int count : { 3, 1000, 10 }) // it grows, and is used again
  {
    list.clear();
    EXPECT_EQ(list.size(), 0u);
    for (int i = 0; i < count; ++i)
    {
      list.makeRoom(2);
      list.add(7 * i);
    }
    ASSERT_EQ(list.view().size(), static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
    {
      EXPECT_EQ(list.view()[i], 7 * i);
    }
    list.shrink(2);
    list.makeRoom(1);
    list.add(-1);
    EXPECT_EQ(std::vector<int>(list.view().begin(), list.view().end()), (std::vector<int>{ 0, 7, -1 }));
  }
}

TEST(Scratch, TakesOnlyWhatIsWanted)
{
  ransmesh::Scratch<int> list;
  list.makeRoom(4);
  for (int i = 0; i < 4; ++i)
  {
    list.addIf(i % 2 == 1, i);
  }
  EXPECT_EQ(std::vector<int>(list.view().begin(), list.view().end()), (std::vector<int>{ 1, 3 }));
}

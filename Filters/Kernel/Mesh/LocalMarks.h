// Marks on a few of many numbered things, cleared in constant time.
#pragma once

#include "Mesh/MeshData.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ransmesh
{
// As Marks, for work that goes on around one place of a large mesh: the marks are a small hash table, which stays
// in the cache where an array with a place for each thing would not.
class LocalMarks
{
public:
  // Unmarks everything.
  void clear()
  {
    count_ = 0;
    if (++current_ == 0) // the stamps have been through: begin anew
    {
      entries_.assign(entries_.size(), {});
      current_ = 1;
    }
  }
  bool test(Index i) const { return entries_[find(i)].stamp == current_; }
  // Marks i; false if it was marked already.
  bool set(Index i)
  {
    Entry& entry = entries_[find(i)];
    if (entry.stamp == current_)
    {
      return false;
    }
    entry = { i, current_ };
    if (2 * ++count_ > entries_.size())
    {
      grow();
    }
    return true;
  }

private:
  struct Entry
  {
    Index number = None;
    std::uint32_t stamp = 0;
  };

  // The entry of i, or the free one where it belongs.
  std::size_t find(Index i) const
  {
    std::size_t place = (static_cast<std::uint32_t>(i) * 0x9e3779b1U) >> shift_; // Fibonacci hashing
    while (entries_[place].stamp == current_ && entries_[place].number != i)
    {
      place = (place + 1) & (entries_.size() - 1);
    }
    return place;
  }

  void grow()
  {
    std::vector<Entry> old(2 * entries_.size());
    old.swap(entries_);
    --shift_;
    for (const Entry& entry : old)
    {
      if (entry.stamp == current_)
      {
        entries_[find(entry.number)] = entry;
      }
    }
  }

  static constexpr int FirstBits = 9;
  std::vector<Entry> entries_ = std::vector<Entry>(std::size_t{ 1 } << FirstBits);
  int shift_ = 32 - FirstBits;
  std::size_t count_ = 0;
  std::uint32_t current_ = 1;
};
} // namespace ransmesh

// Own numbers for, or marks on, a few of many numbered things, cleared in constant time.
#pragma once

#include "Mesh/MeshData.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ransmesh
{
// For work that goes on around one place of a large mesh: a small hash table, which stays in the cache where an
// array with a place for each thing would not.
template <class Thing>
class LocalNumbersOf
{
public:
  // Forgets everything.
  void clear()
  {
    count_ = 0;
    if (++current_ == 0) // the stamps have been through: begin anew
    {
      entries_.assign(entries_.size(), {});
      current_ = 1;
    }
  }
  // How many things have numbers: 0 to count() - 1, in the order in which they were added.
  int count() const { return count_; }
  bool has(Thing thing) const { return entries_[find(thing)].stamp == current_; }
  // The thing's number; it gets the next one if it has none.
  int add(Thing thing)
  {
    Entry& entry = entries_[find(thing)];
    if (entry.stamp == current_)
    {
      return entry.number;
    }
    entry = { thing, current_, count_++ };
    if (2 * static_cast<std::size_t>(count_) > entries_.size())
    {
      grow();
    }
    return count_ - 1;
  }

private:
  struct Entry
  {
    Thing thing{};
    std::uint32_t stamp = 0;
    int number = 0;
  };

  // The entry of the thing, or the free one where it belongs.
  std::size_t find(Thing thing) const
  {
    std::size_t place =
      (static_cast<std::uint64_t>(thing) * 0x9e3779b97f4a7c15ULL) >> shift_; // Fibonacci hashing
    while (entries_[place].stamp == current_ && entries_[place].thing != thing)
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
        entries_[find(entry.thing)] = entry;
      }
    }
  }

  static constexpr int FirstBits = 9;
  std::vector<Entry> entries_ = std::vector<Entry>(std::size_t{ 1 } << FirstBits);
  int shift_ = 64 - FirstBits;
  int count_ = 0;
  std::uint32_t current_ = 1;
};

using LocalNumbers = LocalNumbersOf<Index>;

class LocalMarks
{
public:
  // Unmarks everything.
  void clear() { numbers_.clear(); }
  bool test(Index thing) const { return numbers_.has(thing); }
  // Marks the thing; false if it was marked already.
  bool set(Index thing)
  {
    const int next = numbers_.count();
    return numbers_.add(thing) == next;
  }

private:
  LocalNumbers numbers_;
};
} // namespace ransmesh

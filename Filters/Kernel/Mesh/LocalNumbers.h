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

// The same for things that have an Index: when a thing came and which it is, compared as one number.
template <class Entry>
class LocalTable
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

protected:
  std::uint64_t wordOf(Index thing) const
  {
    return static_cast<std::uint64_t>(current_) << 32 | static_cast<std::uint32_t>(thing);
  }
  // Where the word is, or the free place where it belongs.
  std::size_t find(std::uint64_t word) const
  {
    std::size_t place = (static_cast<std::uint32_t>(word) * 0x9e3779b1U) >> shift_; // Fibonacci hashing
    while (entries_[place].word != word && entries_[place].word >> 32 == current_)
    {
      place = (place + 1) & (entries_.size() - 1);
    }
    return place;
  }
  void enter(std::size_t place, const Entry& entry)
  {
    entries_[place] = entry;
    if (2 * static_cast<std::size_t>(++count_) > entries_.size())
    {
      grow();
    }
  }

  static constexpr int FirstBits = 9;
  std::vector<Entry> entries_ = std::vector<Entry>(std::size_t{ 1 } << FirstBits);
  int count_ = 0;

private:
  [[gnu::noinline]] void grow() // inlined, it would keep the loops that mark from being so
  {
    std::vector<Entry> old(2 * entries_.size());
    old.swap(entries_);
    --shift_;
    for (const Entry& entry : old)
    {
      if (entry.word >> 32 == current_)
      {
        entries_[find(entry.word)] = entry;
      }
    }
  }

  int shift_ = 32 - FirstBits;
  std::uint32_t current_ = 1;
};

struct LocalMark
{
  std::uint64_t word = 0;
};

struct LocalNumber
{
  std::uint64_t word = 0;
  int number = 0;
};

class LocalMarks : public LocalTable<LocalMark>
{
public:
  bool test(Index thing) const
  {
    const std::uint64_t word = wordOf(thing);
    return entries_[find(word)].word == word;
  }
  // Marks the thing; false if it was marked already.
  bool set(Index thing)
  {
    const std::uint64_t word = wordOf(thing);
    const std::size_t place = find(word);
    if (entries_[place].word == word)
    {
      return false;
    }
    enter(place, { word });
    return true;
  }
};

class LocalNumbers : public LocalTable<LocalNumber>
{
public:
  // How many things have numbers: 0 to count() - 1, in the order in which they were added.
  int count() const { return count_; }
  bool has(Index thing) const
  {
    const std::uint64_t word = wordOf(thing);
    return entries_[find(word)].word == word;
  }
  // The thing's number; it gets the next one if it has none.
  int add(Index thing)
  {
    const std::uint64_t word = wordOf(thing);
    const std::size_t place = find(word);
    if (entries_[place].word == word)
    {
      return entries_[place].number;
    }
    const int next = count_;
    enter(place, { word, next });
    return next;
  }
};
} // namespace ransmesh

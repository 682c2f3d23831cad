// Own numbers for, or marks on, a few of many numbered things, cleared in constant time.
#pragma once

#include "Mesh/MeshData.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ransmesh
{
// Which thing, and when it came: after which clearing.
template <class Thing>
struct LocalKey
{
  Thing thing{};
  std::uint32_t stamp = 0;

  LocalKey() = default;
  LocalKey(Thing which, std::uint32_t when)
    : thing(which)
    , stamp(when)
  {
  }
  std::uint32_t when() const { return stamp; }
  std::uint32_t hash() const
  {
    return static_cast<std::uint32_t>((static_cast<std::uint64_t>(thing) * 0x9e3779b97f4a7c15ULL) >> 32);
  }
  // Whether another thing came after the same clearing.
  bool isBesides(const LocalKey& other) const { return stamp == other.stamp && !(thing == other.thing); }
  bool operator==(const LocalKey&) const = default;
};

// What has an Index fits into one word with its stamp, and is compared as one.
template <>
struct LocalKey<Index>
{
  std::uint64_t word = 0;

  LocalKey() = default;
  LocalKey(Index which, std::uint32_t when)
    : word(static_cast<std::uint64_t>(when) << 32 | static_cast<std::uint32_t>(which))
  {
  }
  std::uint32_t when() const { return static_cast<std::uint32_t>(word >> 32); }
  std::uint32_t hash() const { return static_cast<std::uint32_t>(word) * 0x9e3779b1U; }
  // By one comparison, hardly ever true: whether it is the same thing would be anybody's guess.
  bool isBesides(const LocalKey& other) const { return (word ^ other.word) - 1 < 0xffffffffU; }
  bool operator==(const LocalKey&) const = default;
};

// For work that goes on around one place of a large mesh: a small hash table, which stays in the cache where an
// array with a place for each thing would not. An Entry begins with its LocalKey. The hash is Fibonacci's.
template <class Thing, class Entry>
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
  LocalKey<Thing> keyOf(Thing thing) const { return { thing, current_ }; }
  // Where the key is, or the free place where it belongs.
  std::size_t find(const LocalKey<Thing>& key) const
  {
    std::size_t place = key.hash() >> shift_;
    while (entries_[place].key.isBesides(key))
    {
      place = (place + 1) & (entries_.size() - 1);
    }
    return place;
  }
  void enter(std::size_t place, const Entry& entry, bool fresh = true)
  {
    entries_[place] = entry;
    count_ += static_cast<int>(fresh);
    if (2 * static_cast<std::size_t>(count_) > entries_.size())
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
      if (entry.key.when() == current_)
      {
        entries_[find(entry.key)] = entry;
      }
    }
  }

  int shift_ = 32 - FirstBits;
  std::uint32_t current_ = 1;
};

struct LocalMark
{
  LocalKey<Index> key;
};

class LocalMarks : public LocalTable<Index, LocalMark>
{
public:
  bool test(Index thing) const
  {
    const LocalKey<Index> key = keyOf(thing);
    return entries_[find(key)].key == key;
  }
  // Marks the thing; false if it was marked already. No branch depends on that.
  bool set(Index thing)
  {
    const LocalKey<Index> key = keyOf(thing);
    const std::size_t place = find(key);
    const bool fresh = !(entries_[place].key == key);
    enter(place, { key }, fresh);
    return fresh;
  }
};

template <class Thing>
struct LocalNumber
{
  LocalKey<Thing> key;
  int number = 0;
};

template <class Thing>
class LocalNumbersOf : public LocalTable<Thing, LocalNumber<Thing>>
{
public:
  // How many things have numbers: 0 to count() - 1, in the order in which they were added.
  int count() const { return this->count_; }
  bool has(Thing thing) const
  {
    const LocalKey<Thing> key = this->keyOf(thing);
    return this->entries_[this->find(key)].key == key;
  }
  // The thing's number; it gets the next one if it has none. No branch depends on that.
  int add(Thing thing)
  {
    const LocalKey<Thing> key = this->keyOf(thing);
    const std::size_t place = this->find(key);
    const bool fresh = !(this->entries_[place].key == key);
    const int number = fresh ? this->count_ : this->entries_[place].number;
    this->enter(place, { key, number }, fresh);
    return number;
  }
};

using LocalNumbers = LocalNumbersOf<Index>;
} // namespace ransmesh

// Numbers of faces, found by the faces' points: eight bytes an entry, the points stay where they are.
#ifndef FaceHash_h
#define FaceHash_h

#include "CellFaces.h"

#include <vector>

namespace ransmesh
{
class FaceHash
{
public:
  static constexpr std::uint32_t None = 0xFFFFFFFF;

  // Empties it and makes room for so many entries.
  void reset(std::size_t entries) { entries_.assign(entries + entries / 2 + 8, {}); }

  // The number of the face of that key, for which keyAt(number) gives the key of an entry; None if there is none.
  template <class KeyAt>
  std::uint32_t find(const FaceKey& key, KeyAt keyAt) const
  {
    return entries_[place(key, keyAt)].number;
  }

  // The number of the face of that key; `number` is entered and None returned if there is none.
  template <class KeyAt>
  std::uint32_t findOrInsert(const FaceKey& key, std::uint32_t number, KeyAt keyAt)
  {
    Entry& entry = entries_[place(key, keyAt)];
    if (entry.number != None)
    {
      return entry.number;
    }
    entry = { key.hash(), number };
    return None;
  }

private:
  struct Entry
  {
    std::uint32_t hash = 0;
    std::uint32_t number = None;
  };

  // Where the key is, or where it would be entered.
  template <class KeyAt>
  std::size_t place(const FaceKey& key, KeyAt keyAt) const
  {
    const std::uint32_t hash = key.hash();
    std::size_t at = (static_cast<std::uint64_t>(hash) * entries_.size()) >> 32;
    while (entries_[at].number != None && (entries_[at].hash != hash || !(keyAt(entries_[at].number) == key)))
    {
      at = at + 1 == entries_.size() ? 0 : at + 1;
    }
    return at;
  }

  std::vector<Entry> entries_;
};
} // namespace ransmesh

#endif

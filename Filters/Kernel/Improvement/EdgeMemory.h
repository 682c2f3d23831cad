// When edges were last tried in vain.
#pragma once

#include "Mesh/MeshData.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ransmesh
{
// Poor tetrahedra stand in groups, around edges that they share: each asks for the same edge. One table that fits the
// cache, in which later edges push out earlier ones.
class EdgeMemory
{
public:
  // The count of changes that was noted, or 0.
  std::uint32_t triedAt(Index a, Index b) const
  {
    const Entry& entry = entries_[placeOf(ends(a, b))];
    return entry.ends == ends(a, b) ? entry.triedAt : 0;
  }
  void note(Index a, Index b, std::uint32_t at) { entries_[placeOf(ends(a, b))] = { ends(a, b), at }; }

private:
  struct Entry
  {
    std::uint64_t ends = 0;
    std::uint32_t triedAt = 0;
  };

  static std::uint64_t ends(Index a, Index b)
  {
    return static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint64_t>(std::max(a, b));
  }
  static std::size_t placeOf(std::uint64_t ends) { return (ends * 0x9e3779b97f4a7c15ULL) >> (64 - Bits); }

  static constexpr int Bits = 12;
  std::vector<Entry> entries_ = std::vector<Entry>(std::size_t{ 1 } << Bits);
};
} // namespace ransmesh

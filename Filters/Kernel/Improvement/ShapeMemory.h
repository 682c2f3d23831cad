// The shapes of the tetrahedra that were looked at lately.
#pragma once

#include "Mesh/MeshData.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ransmesh
{
// Swaps and moves ask again and again for the shapes of the same few tetrahedra. One table that fits the cache
// is quicker than computing them, and than a list of all tetrahedra's.
class ShapeMemory
{
public:
  // The shape of the tetrahedron, or anything above ceiling if it is above that: as it was computed before, or
  // else by compute(), whose answer is understood in the same way.
  template <class Compute>
  double of(Index tet, double ceiling, Compute compute)
  {
    Entry& entry = placeOf(tet);
    const bool isKnown = entry.tet == tet && entry.era == era_;
    if (!isKnown || !(entry.shape <= entry.exactUpTo || ceiling <= entry.exactUpTo))
    {
      entry = { tet, era_, compute(), ceiling };
    }
    return entry.shape;
  }
  // To be called when the tetrahedron has changed.
  void forget(Index tet)
  {
    Entry& entry = placeOf(tet);
    entry.tet = entry.tet == tet ? None : entry.tet;
  }
  void forgetAll() { ++era_; }

private:
  static constexpr std::size_t Size = std::size_t{ 1 } << 14;
  struct Entry
  {
    Index tet = None;
    std::uint32_t era = 0;
    double shape = 0;
    double exactUpTo = 0;
  };

  Entry& placeOf(Index tet) { return entries_[static_cast<std::size_t>(tet) % Size]; }

  std::vector<Entry> entries_ = std::vector<Entry>(Size);
  std::uint32_t era_ = 0;
};
} // namespace ransmesh

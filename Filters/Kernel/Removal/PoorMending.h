// Swaps and movement of the removal: between its passes, and of what it leaves.
#pragma once

#include "Boundary/BoundaryRules.h"
#include "Improvement/LocalImprovement.h"
#include "Mesh/Traversal.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ransmesh
{
// Below this quality swaps are tried around points that do not go, where the walls allow good ones.
inline constexpr double PoorQuality = 0.12;
// And below this one of what is left in the end: the front's rise mends the rest.
inline constexpr double PoorQualityAtLast = 0.06;

class PoorMending
{
public:
  PoorMending(TetMesh& mesh, const BoundaryRules& rules)
    : mesh_(mesh)
    , improvement_(mesh, rules)
    , traversal_(mesh)
  {
  }

  // To be told of all tetrahedra that others made; remembers those of a quality below poor (0: none) for mendAll.
  void note(std::span<const Index> made, double poor);

  // To be called before the next four when others may have changed the mesh.
  void begin();
  // As those of LocalImprovement.
  bool move(Index v, double keep);
  bool moveTowards(Index v, const Vector3& place, double floor);
  // Swaps the tetrahedra at v whose quality is below poor; gives how many swaps there were.
  std::size_t swapAround(Index v, double poor);
  // Swaps away the tetrahedra that were noted, and those that the swaps made of them, where their quality is below poor.
  std::size_t mendAll(double poor);

private:
  bool swap(Index tet);
  bool noteMove(bool moved);
  void noteChange(std::span<const Index> tets);

  TetMesh& mesh_;
  LocalImprovement improvement_;
  Traversal traversal_;
  std::vector<Index> ball_;
  std::vector<Index> poor_;
  // By tetrahedron: when it changed last, as a count of changes. Empty until the first swap is tried.
  std::vector<std::uint32_t> changedAt_;
  std::uint32_t now_ = 1;
};
} // namespace ransmesh

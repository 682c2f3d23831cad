// The regions of a mesh, kept while its points and tetrahedra change.
#pragma once

#include "Mesh/MeshData.h"

#include <map>
#include <utility>
#include <vector>

namespace ransmesh
{
class RegionMemory
{
public:
  RegionMemory() = default;
  // region: the number, above 0, of each tetrahedron's region; empty: there is nothing to remember.
  RegionMemory(const MeshData& mesh, const std::vector<int>& region);

  // The number of each tetrahedron's region in what the mesh has become: each part that triangles do not divide is of
  // the region that most of its points come from. origin: of each point, the point of the mesh of then that it is, or
  // lies beside. Empty where there was nothing to remember.
  std::vector<int> recall(const MeshData& mesh, const std::vector<Index>& origin) const;

private:
  int regionOfPart(const std::map<int, std::size_t>& votes) const;

  std::map<int, std::size_t> pointsOf_; // of each region
  std::vector<std::pair<Index, int>>
    regionsAt_; // point and region, sorted; only where there are several regions
};
} // namespace ransmesh

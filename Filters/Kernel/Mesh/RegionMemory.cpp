#include "Mesh/RegionMemory.h"

#include "Mesh/Regions.h"

#include <algorithm>

namespace ransmesh
{
RegionMemory::RegionMemory(const MeshData& mesh, const std::vector<int>& region)
{
  for (const int number : region)
  {
    pointsOf_.try_emplace(number, 0);
  }
  if (pointsOf_.size() < 2)
  {
    return;
  }
  for (std::size_t t = 0; t < region.size(); ++t)
  {
    for (const Index v : mesh.tetrahedra[t])
    {
      regionsAt_.emplace_back(v, region[t]);
    }
  }
  std::sort(regionsAt_.begin(), regionsAt_.end());
  regionsAt_.erase(std::unique(regionsAt_.begin(), regionsAt_.end()), regionsAt_.end());
  for (const auto& [point, number] : regionsAt_)
  {
    ++pointsOf_[number];
  }
}

// All points of a part are of its own region, and some of others, too. Where that does not tell, because the part has
// no points of its own, it is the smaller one.
int RegionMemory::regionOfPart(const std::map<int, std::size_t>& votes) const
{
  const auto isLess = [this](const auto& a, const auto& b)
  { return a.second != b.second ? a.second < b.second : pointsOf_.at(a.first) > pointsOf_.at(b.first); };
  const auto most = std::max_element(votes.begin(), votes.end(), isLess);
  return most == votes.end() ? pointsOf_.begin()->first : most->first;
}

std::vector<int> RegionMemory::recall(const MeshData& mesh, const std::vector<Index>& origin) const
{
  if (pointsOf_.empty())
  {
    return {};
  }
  if (pointsOf_.size() == 1)
  {
    return std::vector<int>(mesh.tetrahedra.size(), pointsOf_.begin()->first);
  }
  std::vector<int> part = numberRegions(mesh);
  std::vector<std::map<int, std::size_t>> votes(
    part.empty() ? 0 : *std::max_element(part.begin(), part.end()));
  for (std::size_t t = 0; t < part.size(); ++t)
  {
    for (const Index v : mesh.tetrahedra[t])
    {
      auto at = std::lower_bound(regionsAt_.begin(), regionsAt_.end(), std::pair(origin[v], 0));
      for (; at != regionsAt_.end() && at->first == origin[v]; ++at)
      {
        ++votes[part[t] - 1][at->second];
      }
    }
  }
  std::vector<int> region;
  std::transform(votes.begin(), votes.end(), std::back_inserter(region),
    [this](const auto& ofPart) { return regionOfPart(ofPart); });
  std::transform(part.begin(), part.end(), part.begin(), [&region](int p) { return region[p - 1]; });
  return part;
}
} // namespace ransmesh

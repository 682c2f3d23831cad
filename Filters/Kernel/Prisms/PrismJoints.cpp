#include "Prisms/PrismJoints.h"

#include "Prisms/JoinedGroups.h"
#include "Prisms/PrismHalves.h"
#include "Prisms/PrismPairs.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
std::vector<PrismHalves> joinHalves(JoinedGroups& groups)
{
  std::vector<PrismHalves> joined;
  for (const PrismHalves& halves : findHalves(groups))
  {
    if (groups[halves.one].count == 1 && groups[halves.two].count == 2)
    {
      groups.join(halves.two, halves.one);
      joined.push_back(halves);
    }
  }
  return joined;
}

// Would a prism keep all its quadrilaterals?
bool canStay(const JoinedGroups& groups, Index g)
{
  const std::vector<GroupSide> sides = groups.sidesOf(g);
  const auto isGood = [&groups](const GroupSide& side)
  { return groups.isClosed(side) || pairsFrom(groups, side).has_value(); };
  return std::count_if(sides.begin(), sides.end(), isGood) >= 3;
}

// Halves that would not have all their sides are parted again, and so on with those beside them.
void partOthers(JoinedGroups& groups, std::vector<PrismHalves>& joined)
{
  for (bool isChanged = true; isChanged;)
  {
    const auto poor = std::stable_partition(joined.begin(), joined.end(),
      [&groups](const PrismHalves& halves) { return canStay(groups, halves.two); });
    std::for_each(
      poor, joined.end(), [&groups](const PrismHalves& halves) { groups.partLast(halves.two, halves.one); });
    isChanged = poor != joined.end();
    joined.erase(poor, joined.end());
  }
}

void joinPairsBeyond(JoinedGroups& groups, Index g)
{
  for (const GroupSide& side : groups.sidesOf(g))
  {
    const auto pairs = groups.isClosed(side) ? std::nullopt : pairsFrom(groups, side);
    for (const auto& [into, from] : pairs.value_or(std::vector<PrismPair>()))
    {
      groups.join(into, from);
    }
  }
}
} // namespace

std::vector<Index> joinPrisms(
  const MeshData& mesh, const FaceMatching& matching, const std::vector<Index>& prism)
{
  JoinedGroups groups(mesh, matching, prism);
  std::vector<PrismHalves> joined = joinHalves(groups);
  partOthers(groups, joined);
  for (const PrismHalves& halves : joined)
  {
    joinPairsBeyond(groups, halves.two);
  }
  return groups.groupOf();
}
} // namespace ransmesh

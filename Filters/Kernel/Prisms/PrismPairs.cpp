#include "Prisms/PrismPairs.h"

#include "Mesh/MixedMesh.h"

namespace ransmesh
{
namespace
{
// The triangle of a prism that lies opposite one of its own; none where several do.
std::optional<OuterFace> opposite(const JoinedGroups& groups, Index g, const OuterFace& triangle)
{
  std::optional<OuterFace> found;
  for (const OuterFace& face : groups.outside(groups[g]))
  {
    if (CommonPoints(face, triangle).count == 0)
    {
      if (found)
      {
        return std::nullopt;
      }
      found = face;
    }
  }
  return found;
}

// Have two prisms a quadrilateral in common that has the side's diagonal on its border?
bool areSideBySide(const JoinedGroups& groups, const GroupSide& side)
{
  std::vector<OuterFace> common;
  for (const OuterFace& face : groups.outside(groups[side.group[0]]))
  {
    if (groups.beyond(face.half) == side.group[1])
    {
      common.push_back(face);
    }
  }
  if (common.size() != 2 || CommonPoints(common[0], common[1]).count != 2)
  {
    return false;
  }
  const CommonPoints edge(side.face[0], side.face[1]);
  const auto holds = [&edge](const OuterFace& face)
  { return face.has(edge.point[0]) && face.has(edge.point[1]); };
  return holds(common[0]) != holds(common[1]); // both: it is the diagonal
}

bool canBeOne(const JoinedGroups& groups, const GroupSide& side)
{
  return side.group[0] != None && side.group[1] != None && side.group[0] != side.group[1] &&
    groups.isQuadrilateral(side.face[0], side.face[1]) && groups.isPrism(side.group[0]) &&
    groups.isPrism(side.group[1]) && areSideBySide(groups, side);
}

// Of the triangle at a prism's other end, the point on the same edge as a point of the first one. A prism is cut so
// that one of both is in three of its tetrahedra, the other in one; or both in two.
Index across(const JoinedGroups& groups, Index g, Index point, const OuterFace& end)
{
  const auto tetsAt = [&](Index p)
  {
    return std::count_if(groups[g].begin(), groups[g].end(),
      [&](Index t)
      {
        const auto& v = groups.mesh().tetrahedra[t];
        return std::find(v.begin(), v.end(), p) != v.end();
      });
  };
  const auto wanted = GroupTets::Prism + 1 - tetsAt(point);
  const auto& v = end.corner;
  const auto found = std::find_if(v.begin(), v.end(), [&](Index p) { return tetsAt(p) == wanted; });
  return found == v.end() ? None : *found;
}

// Are the two prisms between two such pairs of triangles a sound hexahedron?
bool isHexahedron(
  const JoinedGroups& groups, const GroupSide& near, const OuterFace& farFirst, const OuterFace& farSecond)
{
  const std::array<Index, 4> inward = near.corners();
  const std::array<Index, 4> base{ inward[0], inward[3], inward[2], inward[1] };
  Hexahedron cell{ base[0], base[1], base[2], base[3] };
  for (int i = 0; i < 4; ++i)
  {
    const Index first = near.face[0].has(base[i]) ? across(groups, near.group[0], base[i], farFirst) : None;
    const Index second = near.face[1].has(base[i]) ? across(groups, near.group[1], base[i], farSecond) : None;
    if (first != None && second != None && first != second)
    {
      return false;
    }
    cell[i + 4] = first != None ? first : second;
    if (cell[i + 4] == None)
    {
      return false;
    }
  }
  return isSound(cell, groups.mesh().points);
}
} // namespace

std::optional<std::vector<PrismPair>> pairsFrom(const JoinedGroups& groups, GroupSide side)
{
  std::vector<PrismPair> pairs;
  while (canBeOne(groups, side) && pairs.size() <= groups.size())
  {
    pairs.push_back({ side.group[0], side.group[1] });
    const auto first = opposite(groups, side.group[0], side.face[0]);
    const auto second = opposite(groups, side.group[1], side.face[1]);
    if (!first || !second || !isHexahedron(groups, side, *first, *second))
    {
      return std::nullopt;
    }
    side = groups.sideAt(*first, *second);
  }
  const bool isEnd = groups.isClosed(side) && groups.isQuadrilateral(side.face[0], side.face[1]);
  return isEnd ? std::optional(pairs) : std::nullopt;
}
} // namespace ransmesh

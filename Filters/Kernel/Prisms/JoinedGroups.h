// Groups of tetrahedra, each a prism or a part of one, while they are joined: who is in which, and what their outsides
// look like.
#pragma once

#include "Mesh/FaceMatching.h"
#include "Mesh/TetMesh.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace ransmesh
{
// The tetrahedra of a group.
struct GroupTets
{
  static constexpr int Most = 6;
  static constexpr int Prism = 3; // that a whole prism has

  const Index* begin() const { return tet.data(); }
  const Index* end() const { return tet.data() + std::min(count, Most); }
  void add(Index t)
  {
    if (count < Most)
    {
      tet[count] = t;
    }
    ++count;
  }

  std::array<Index, Most> tet{};
  int count = 0; // more than Most: all others are left out
};

// A triangle on the outside of a group, turned inward, and its face.
struct OuterFace
{
  std::array<Index, 3> corner;
  HalfFace half;

  bool has(Index v) const { return std::find(corner.begin(), corner.end(), v) != corner.end(); }
};

// The points that two triangles have in common.
struct CommonPoints
{
  CommonPoints(const OuterFace& a, const OuterFace& b);

  std::array<Index, 3> point{ None, None, None };
  int count = 0;
};

// Two triangles of a group's outside that make a quadrilateral, and the groups beyond them, or None.
struct GroupSide
{
  OuterFace face[2];
  Index group[2];

  // Its corners in order, turned inward; the triangles meet between the second and the fourth.
  std::array<Index, 4> corners() const;
};

class JoinedGroups
{
public:
  // prism: of each tetrahedron, those of one group share a number; negative for none. What has more than three
  // tetrahedra is no prism: its tetrahedra are in no group.
  JoinedGroups(const MeshData& mesh, const FaceMatching& matching, const std::vector<Index>& prism);

  const MeshData& mesh() const { return mesh_; }
  const std::vector<Index>& groupOf() const { return groupOf_; } // of each tetrahedron; negative for none
  std::size_t size() const { return members_.size(); }           // some groups are empty
  const GroupTets& operator[](Index g) const { return members_[g]; }
  bool isPrism(Index g) const { return members_[g].count == GroupTets::Prism; }

  // The second group's tetrahedra go over to the first, at its end.
  void join(Index into, Index from);
  // The last tetrahedron becomes a group again.
  void partLast(Index from, Index into);

  // The group beyond a face; None where there is none.
  Index beyond(HalfFace h) const;
  // The boundary patch upon a face; 0 for none.
  int patchOn(HalfFace h) const;

  // The outside of tetrahedra that are, or would be, one group.
  std::vector<OuterFace> outside(const GroupTets& tets) const;
  // Are two triangles the halves of a quadrilateral that is flat, and convex?
  bool isQuadrilateral(const OuterFace& a, const OuterFace& b) const;
  // All pairs of triangles on a group's outside that make quadrilaterals.
  std::vector<GroupSide> sidesOf(Index g) const;
  // What lies beyond two triangles of a group.
  GroupSide sideAt(const OuterFace& a, const OuterFace& b) const
  {
    return { { a, b }, { beyond(a.half), beyond(b.half) } };
  }
  // Can both be one quadrilateral's: does one patch, or one whole prism, lie beyond?
  bool isClosed(const GroupSide& side) const;

private:
  bool isInside(HalfFace h, const GroupTets& tets) const;
  Vector3 normalOf(Index a, Index b, Index c) const;

  const MeshData& mesh_;
  const FaceMatching& matching_;
  std::vector<Index> groupOf_;
  std::vector<GroupTets> members_; // of each group
};
} // namespace ransmesh

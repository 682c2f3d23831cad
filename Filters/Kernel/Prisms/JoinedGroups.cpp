#include "Prisms/JoinedGroups.h"

namespace ransmesh
{
namespace
{
constexpr double LeastFlatness = 0.985; // cosine of what the halves of a quadrilateral turn by: 10 degrees
constexpr double LeastPart = 0.1;       // of a quadrilateral that its other diagonal cuts off

// Where in a triangle the point stands that another has not.
std::size_t tipOf(const OuterFace& face, const OuterFace& other)
{
  const auto& v = face.corner;
  return std::find_if(v.begin(), v.end(), [&other](Index p) { return !other.has(p); }) - v.begin();
}
} // namespace

CommonPoints::CommonPoints(const OuterFace& a, const OuterFace& b)
{
  for (const Index v : a.corner)
  {
    if (b.has(v))
    {
      point[count++] = v;
    }
  }
}

std::array<Index, 4> GroupSide::corners() const
{
  const auto& v = face[0].corner;
  const std::size_t tip = tipOf(face[0], face[1]);
  return { v[tip], v[(tip + 1) % 3], face[1].corner[tipOf(face[1], face[0])], v[(tip + 2) % 3] };
}

JoinedGroups::JoinedGroups(
  const MeshData& mesh, const FaceMatching& matching, const std::vector<Index>& prism)
  : mesh_(mesh)
  , matching_(matching)
  , groupOf_(prism)
{
  const Index most = prism.empty() ? None : *std::max_element(prism.begin(), prism.end());
  members_.resize(static_cast<std::size_t>(most) + 1);
  for (std::size_t t = 0; t < prism.size(); ++t)
  {
    if (prism[t] >= 0)
    {
      members_[prism[t]].add(static_cast<Index>(t));
    }
  }
  for (Index& g : groupOf_)
  {
    g = g >= 0 && members_[g].count > GroupTets::Prism ? None : g;
  }
  for (GroupTets& members : members_)
  {
    members = members.count > GroupTets::Prism ? GroupTets() : members;
  }
}

void JoinedGroups::join(Index into, Index from)
{
  for (const Index t : members_[from])
  {
    groupOf_[t] = into;
    members_[into].add(t);
  }
  members_[from] = {};
}

void JoinedGroups::partLast(Index from, Index into)
{
  GroupTets& both = members_[from];
  const Index last = both.tet[--both.count];
  members_[into].add(last);
  groupOf_[last] = into;
}

Index JoinedGroups::beyond(HalfFace h) const
{
  const HalfFace other = matching_.opposite[h];
  return other == FaceMatching::Unmatched || isBoundary(other) ? None : groupOf_[tetOf(other)];
}

int JoinedGroups::patchOn(HalfFace h) const
{
  const HalfFace other = matching_.opposite[h];
  return other != FaceMatching::Unmatched && isBoundary(other) ? mesh_.trianglePatch[boundaryFaceOf(other)]
                                                               : 0;
}

bool JoinedGroups::isInside(HalfFace h, const GroupTets& tets) const
{
  const HalfFace other = matching_.opposite[h];
  return other != FaceMatching::Unmatched && !isBoundary(other) &&
    std::find(tets.begin(), tets.end(), tetOf(other)) != tets.end();
}

std::vector<OuterFace> JoinedGroups::outside(const GroupTets& tets) const
{
  std::vector<OuterFace> faces;
  for (const Index t : tets)
  {
    const auto& v = mesh_.tetrahedra[t];
    for (int f = 0; f < 4; ++f)
    {
      const HalfFace h = halfFace(t, f);
      if (!isInside(h, tets))
      {
        faces.push_back({ { v[FaceCorners[f][0]], v[FaceCorners[f][1]], v[FaceCorners[f][2]] }, h });
      }
    }
  }
  return faces;
}

Vector3 JoinedGroups::normalOf(Index a, Index b, Index c) const
{
  return cross(mesh_.points[b] - mesh_.points[a], mesh_.points[c] - mesh_.points[a]);
}

bool JoinedGroups::isQuadrilateral(const OuterFace& a, const OuterFace& b) const
{
  if (CommonPoints(a, b).count != 2)
  {
    return false;
  }
  const auto& v = a.corner;
  const auto& w = b.corner;
  const Vector3 m = normalOf(v[0], v[1], v[2]);
  const Vector3 n = normalOf(w[0], w[1], w[2]);
  const Vector3 whole = m + n;
  const double least = LeastPart * dot(whole, whole);
  const auto [tip, next, other, last] = GroupSide{ { a, b }, {} }.corners();
  return dot(m, n) > LeastFlatness * norm(m) * norm(n) && dot(normalOf(tip, next, other), whole) > least &&
    dot(normalOf(tip, other, last), whole) > least;
}

std::vector<GroupSide> JoinedGroups::sidesOf(Index g) const
{
  std::vector<GroupSide> sides;
  const std::vector<OuterFace> faces = outside(members_[g]);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (std::size_t j = i + 1; j < faces.size(); ++j)
    {
      if (isQuadrilateral(faces[i], faces[j]))
      {
        sides.push_back(sideAt(faces[i], faces[j]));
      }
    }
  }
  return sides;
}

bool JoinedGroups::isClosed(const GroupSide& side) const
{
  const int patch = patchOn(side.face[0].half);
  const bool isOnOnePatch = patch > 0 && patch == patchOn(side.face[1].half);
  const Index g = side.group[0];
  return isOnOnePatch || (g != None && g == side.group[1] && members_[g].count >= GroupTets::Prism);
}
} // namespace ransmesh

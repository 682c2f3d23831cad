#include "Prisms/PrismGroups.h"

#include <algorithm>
#include <unordered_map>

namespace ransmesh
{
namespace
{
constexpr double LeastFlatness = 0.866; // cosine of what the halves of a boundary quadrilateral turn by

// The tetrahedra of prisms, those of one prism side by side.
std::vector<Index> sortByPrism(const std::vector<Index>& prism)
{
  std::vector<Index> order;
  for (std::size_t t = 0; t < prism.size(); ++t)
  {
    if (prism[t] >= 0)
    {
      order.push_back(static_cast<Index>(t));
    }
  }
  const auto before = [&prism](Index a, Index b) { return prism[a] < prism[b]; };
  if (!std::is_sorted(order.begin(), order.end(), before))
  {
    std::stable_sort(order.begin(), order.end(), before);
  }
  return order;
}

class GroupFinder
{
public:
  GroupFinder(const MeshData& mesh, const FaceMatching& matching, const std::vector<Index>& prism)
    : mesh_(mesh)
    , matching_(matching)
  {
    collectSheets();
    collectGroups(prism);
  }

  PrismGroups run()
  {
    for (std::size_t g = 0; g < result_.groups.size(); ++g)
    {
      findQuads(static_cast<Index>(g));
    }
    return std::move(result_);
  }

private:
  void collectSheets()
  {
    for (const SheetFace& sheet : matching_.sheets)
    {
      sheetAt_[sheet.side] = sheet.triangle;
      sheetAt_[matching_.opposite[sheet.side]] = sheet.triangle;
    }
  }

  void collectGroups(const std::vector<Index>& prism)
  {
    result_.groupOf.assign(mesh_.tetrahedra.size(), None);
    const std::vector<Index> order = sortByPrism(prism);
    for (std::size_t begin = 0; begin < order.size();)
    {
      std::size_t end = begin + 1;
      while (end < order.size() && prism[order[end]] == prism[order[begin]])
      {
        ++end;
      }
      addGroup(&order[begin], static_cast<int>(end - begin));
      begin = end;
    }
  }

  void addGroup(const Index* tets, int count)
  {
    if (count < 2 || (count > 3 && count != PrismGroup::Most))
    {
      return; // a single tetrahedron stays what it is
    }
    PrismGroup group;
    group.size = count;
    for (int i = 0; i < count; ++i)
    {
      group.tet[i] = tets[i];
      result_.groupOf[tets[i]] = static_cast<Index>(result_.groups.size());
    }
    result_.groups.push_back(group);
  }

  std::array<Index, 3> faceOf(HalfFace h) const
  {
    const auto& v = mesh_.tetrahedra[tetOf(h)];
    const int* corner = FaceCorners[ransmesh::faceOf(h)];
    return { v[corner[0]], v[corner[1]], v[corner[2]] };
  }

  // What lies beyond a face: a group; -patch on the boundary; None.
  struct Beyond
  {
    Index group = None;
    int patch = 0;
    bool isNothing() const { return group == None && patch == 0; }
    bool operator==(const Beyond&) const = default;
  };

  Beyond beyond(HalfFace h) const
  {
    const HalfFace other = matching_.opposite[h];
    if (other == FaceMatching::Unmatched)
    {
      return {};
    }
    if (isBoundary(other))
    {
      return { None, mesh_.trianglePatch[boundaryFaceOf(other)] };
    }
    return { result_.groupOf[tetOf(other)], 0 };
  }

  void findQuads(Index g)
  {
    const PrismGroup group = result_.groups[g];
    for (int i = 0; i < group.size; ++i)
    {
      for (int j = i + 1; j < group.size; ++j)
      {
        for (int face = 0; face < 16; ++face)
        {
          pair(g, halfFace(group.tet[i], face / 4), halfFace(group.tet[j], face % 4));
        }
      }
    }
  }

  // A quadrilateral of two faces of the group g, if they are one.
  void pair(Index g, HalfFace a, HalfFace b)
  {
    const Beyond other = beyond(a);
    if (other.isNothing() || other.group == g || other != beyond(b) ||
      (other.group != None && other.group < g))
    {
      return; // or the other group, which came first, has it already
    }
    LateralQuad quad;
    if (!join(faceOf(a), faceOf(b), quad.corner))
    {
      return;
    }
    quad.group = { g, other.group };
    quad.half[0] = { a, b };
    quad.half[1] = { matching_.opposite[a], matching_.opposite[b] };
    quad.triangle = { triangleAt(a), triangleAt(b) };
    if (isAdmissible(quad))
    {
      add(quad);
    }
  }

  // The quadrilateral of two triangles turned alike that share an edge: apex, edge, apex, edge.
  static bool join(const std::array<Index, 3>& a, const std::array<Index, 3>& b, std::array<Index, 4>& corner)
  {
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        if (a[i] == b[(j + 1) % 3] && a[(i + 1) % 3] == b[j])
        {
          corner = { a[(i + 2) % 3], a[i], b[(j + 2) % 3], a[(i + 1) % 3] };
          return true;
        }
      }
    }
    return false;
  }

  Index triangleAt(HalfFace h) const
  {
    const HalfFace other = matching_.opposite[h];
    if (isBoundary(other))
    {
      return boundaryFaceOf(other);
    }
    const auto sheet = sheetAt_.find(h);
    return sheet == sheetAt_.end() ? None : sheet->second;
  }

  bool isAdmissible(const LateralQuad& quad) const
  {
    const auto [a, b] = quad.triangle;
    if (a == None || b == None)
    {
      return a == b;
    }
    if (mesh_.trianglePatch[a] != mesh_.trianglePatch[b])
    {
      return false;
    }
    const auto normal = [this](const std::array<Index, 3>& v)
    { return cross(mesh_.points[v[1]] - mesh_.points[v[0]], mesh_.points[v[2]] - mesh_.points[v[0]]); };
    const Vector3 m = normal(faceOf(quad.half[0][0]));
    const Vector3 n = normal(faceOf(quad.half[0][1]));
    return dot(m, n) > LeastFlatness * norm(m) * norm(n);
  }

  // Less quadrilaterals so far than there can be, and none with the same faces?
  bool hasRoom(const LateralQuad& quad, int side) const
  {
    if (quad.group[side] == None)
    {
      return true;
    }
    const PrismGroup& group = result_.groups[quad.group[side]];
    const auto overlaps = [&](Index q)
    {
      const LateralQuad& other = result_.quads[q];
      const auto& half = other.half[other.sideOf(quad.group[side])];
      return std::find_first_of(half.begin(), half.end(), quad.half[side].begin(), quad.half[side].end()) !=
        half.end();
    };
    return group.quads < group.mostQuads() &&
      std::none_of(group.quad.begin(), group.quad.begin() + group.quads, overlaps);
  }

  void add(const LateralQuad& quad)
  {
    if (!hasRoom(quad, 0) || !hasRoom(quad, 1))
    {
      return; // no prism: its tetrahedra stay
    }
    for (const Index g : quad.group)
    {
      if (g != None)
      {
        PrismGroup& group = result_.groups[g];
        group.quad[group.quads++] = static_cast<Index>(result_.quads.size());
      }
    }
    result_.quads.push_back(quad);
  }

  const MeshData& mesh_;
  const FaceMatching& matching_;
  std::unordered_map<HalfFace, Index> sheetAt_;
  PrismGroups result_;
};
} // namespace

PrismGroups findPrismGroups(
  const MeshData& mesh, const FaceMatching& matching, const std::vector<Index>& prism)
{
  return GroupFinder(mesh, matching, prism).run();
}
} // namespace ransmesh

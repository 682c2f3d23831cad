#include "Prisms/PrismJoints.h"

#include "Mesh/MixedMesh.h"
#include "Mesh/TetMesh.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <set>

namespace ransmesh
{
namespace
{
using Corners = std::array<Index, 3>;
constexpr double LeastFlatness = 0.985; // cosine of what the halves of a quadrilateral turn by: 10 degrees
constexpr double LeastPart = 0.1;       // of a quadrilateral that its other diagonal cuts off
constexpr int PrismTets = 3;

// A triangle on the outside of a prism, turned inward, and its face.
struct OuterFace
{
  Corners corner;
  HalfFace half;
};

bool has(const Corners& triangle, Index v)
{
  return std::find(triangle.begin(), triangle.end(), v) != triangle.end();
}

// The points that two triangles have in common.
struct CommonPoints
{
  CommonPoints(const Corners& a, const Corners& b)
  {
    for (const Index v : a)
    {
      if (has(b, v))
      {
        point[count++] = v;
      }
    }
  }

  Corners point{ None, None, None };
  int count = 0;
};

// Some tetrahedra: a prism's, or those of two.
struct Members
{
  static constexpr int Most = 6;

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

class PrismJoiner
{
public:
  PrismJoiner(const MeshData& mesh, const FaceMatching& matching, const std::vector<Index>& prism)
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
  }

  std::vector<Index> run()
  {
    dropOthers();
    std::vector<Halves> joined = joinHalves();
    partOthers(joined);
    std::for_each(
      joined.begin(), joined.end(), [this](const Halves& halves) { joinPairsBeyond(halves.two); });
    return std::move(groupOf_);
  }

private:
  void dropOthers()
  {
    for (Index& g : groupOf_)
    {
      g = g >= 0 && members_[g].count > PrismTets ? None : g;
    }
    for (Members& members : members_)
    {
      members = members.count > PrismTets ? Members() : members;
    }
  }

  void join(Index into, Index from)
  {
    for (const Index t : members_[from])
    {
      groupOf_[t] = into;
      members_[into].add(t);
    }
    members_[from] = {};
  }

  // The group beyond a face; None where there is none.
  Index beyond(HalfFace h) const
  {
    const HalfFace other = matching_.opposite[h];
    return other == FaceMatching::Unmatched || isBoundary(other) ? None : groupOf_[tetOf(other)];
  }

  // The outside of tetrahedra that are, or would be, one group.
  std::vector<OuterFace> outside(const Members& tets) const
  {
    std::vector<OuterFace> faces;
    for (const Index t : tets)
    {
      for (int f = 0; f < 4; ++f)
      {
        const HalfFace h = halfFace(t, f);
        const HalfFace other = matching_.opposite[h];
        const bool isInside = other != FaceMatching::Unmatched && !isBoundary(other) &&
          std::find(tets.begin(), tets.end(), tetOf(other)) != tets.end();
        if (!isInside)
        {
          const auto& v = mesh_.tetrahedra[t];
          faces.push_back({ { v[FaceCorners[f][0]], v[FaceCorners[f][1]], v[FaceCorners[f][2]] }, h });
        }
      }
    }
    return faces;
  }

  Vector3 normalOf(Index a, Index b, Index c) const
  {
    return cross(mesh_.points[b] - mesh_.points[a], mesh_.points[c] - mesh_.points[a]);
  }

  // Are two triangles the halves of a quadrilateral that is flat, and convex?
  bool isQuadrilateral(const OuterFace& a, const OuterFace& b) const
  {
    const auto& v = a.corner;
    const auto tip =
      std::find_if(v.begin(), v.end(), [&b](Index p) { return !has(b.corner, p); }) - v.begin();
    if (CommonPoints(a.corner, b.corner).count != 2)
    {
      return false;
    }
    const auto& w = b.corner;
    const Index other = *std::find_if(w.begin(), w.end(), [&a](Index p) { return !has(a.corner, p); });
    const Vector3 m = normalOf(v[0], v[1], v[2]);
    const Vector3 n = normalOf(w[0], w[1], w[2]);
    const Vector3 whole = m + n;
    const double least = LeastPart * dot(whole, whole);
    return dot(m, n) > LeastFlatness * norm(m) * norm(n) &&
      dot(normalOf(v[tip], v[(tip + 1) % 3], other), whole) > least &&
      dot(normalOf(v[tip], other, v[(tip + 2) % 3]), whole) > least;
  }

  double perimeter(const Corners& v) const
  {
    const auto& p = mesh_.points;
    return distance(p[v[0]], p[v[1]]) + distance(p[v[1]], p[v[2]]) + distance(p[v[2]], p[v[0]]);
  }

  // The perimeters of two triangles apart, if three quadrilaterals go around them; the smallest sum of all choices.
  std::optional<double> sizeOfPrism(const std::vector<OuterFace>& faces) const
  {
    std::optional<double> smallest;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      for (std::size_t j = i + 1; j < faces.size(); ++j)
      {
        if (CommonPoints(faces[i].corner, faces[j].corner).count == 0 && goesAround(faces, i, j))
        {
          const double size = perimeter(faces[i].corner) + perimeter(faces[j].corner);
          smallest = std::min(smallest.value_or(size), size);
        }
      }
    }
    return smallest;
  }

  bool goesAround(const std::vector<OuterFace>& faces, std::size_t low, std::size_t high) const
  {
    std::set<std::size_t> partners;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      if (i == low || CommonPoints(faces[i].corner, faces[low].corner).count != 2)
      {
        continue;
      }
      for (std::size_t j = 0; j < faces.size(); ++j)
      {
        const bool isUpper = j != high && CommonPoints(faces[j].corner, faces[high].corner).count == 2;
        if (isUpper && !partners.contains(j) && isQuadrilateral(faces[i], faces[j]))
        {
          partners.insert(j);
          break;
        }
      }
    }
    return partners.size() == 3;
  }

  struct Halves
  {
    double size;
    Index one;
    Index two;
  };

  // Below fans the tetrahedron of one half makes a prism with the wrong other one, too, which is askew.
  std::vector<Halves> joinHalves()
  {
    std::vector<Halves> found;
    for (std::size_t g = 0; g < members_.size(); ++g)
    {
      findPartners(static_cast<Index>(g), found);
    }
    std::stable_sort(
      found.begin(), found.end(), [](const Halves& a, const Halves& b) { return a.size < b.size; });
    std::vector<Halves> joined;
    for (const Halves& halves : found)
    {
      if (members_[halves.one].count == 1 && members_[halves.two].count == 2)
      {
        join(halves.two, halves.one);
        joined.push_back(halves);
      }
    }
    return joined;
  }

  void findPartners(Index g, std::vector<Halves>& found) const
  {
    for (int f = 0; members_[g].count == 1 && f < 4; ++f)
    {
      const Index other = beyond(halfFace(members_[g].tet[0], f));
      if (other == None || members_[other].count != 2)
      {
        continue;
      }
      Members three = members_[other];
      three.add(members_[g].tet[0]);
      const std::vector<OuterFace> faces = outside(three);
      if (const auto size = faces.size() == 8 ? sizeOfPrism(faces) : std::nullopt)
      {
        found.push_back({ *size, g, other });
      }
    }
  }

  // Two triangles that make a quadrilateral, and the prisms beyond them.
  struct Step
  {
    OuterFace face[2];
    Index group[2];
  };

  // All pairs of triangles on a prism's outside that make quadrilaterals.
  std::vector<Step> sidesOf(Index g) const
  {
    std::vector<Step> sides;
    const std::vector<OuterFace> faces = outside(members_[g]);
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      for (std::size_t j = i + 1; j < faces.size(); ++j)
      {
        if (isQuadrilateral(faces[i], faces[j]))
        {
          sides.push_back({ { faces[i], faces[j] }, { beyond(faces[i].half), beyond(faces[j].half) } });
        }
      }
    }
    return sides;
  }

  bool canBeOne(const Step& step) const
  {
    return step.group[0] != None && step.group[1] != None && step.group[0] != step.group[1] &&
      isQuadrilateral(step.face[0], step.face[1]) &&
      areSideBySide(step.group[0], step.group[1], CommonPoints(step.face[0].corner, step.face[1].corner));
  }

  // The triangle of a prism that lies opposite one of its own.
  std::optional<OuterFace> opposite(Index g, const Corners& triangle) const
  {
    std::optional<OuterFace> found;
    for (const OuterFace& face : outside(members_[g]))
    {
      if (CommonPoints(face.corner, triangle).count == 0)
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

  // One patch, and not two?
  bool isOnOnePatch(const Step& step) const
  {
    const auto patch = [this](const OuterFace& face)
    {
      const HalfFace other = matching_.opposite[face.half];
      return other != FaceMatching::Unmatched && isBoundary(other)
        ? mesh_.trianglePatch[boundaryFaceOf(other)]
        : 0;
    };
    return patch(step.face[0]) > 0 && patch(step.face[0]) == patch(step.face[1]);
  }

  // Can both be a quadrilateral: does one patch, or one prism, lie beyond?
  bool isClosed(const Step& step) const
  {
    return isOnOnePatch(step) ||
      (step.group[0] != None && step.group[0] == step.group[1] && members_[step.group[0]].count >= PrismTets);
  }

  // Of the triangle at a prism's other end, the point on the same edge as a point of the first one. A prism is cut so
  // that one of both is in three of its tetrahedra, the other in one; or both in two.
  Index across(Index g, Index point, const Corners& end) const
  {
    const auto tetsAt = [&](Index p)
    {
      return std::count_if(members_[g].begin(), members_[g].end(),
        [&](Index t)
        {
          return std::find(mesh_.tetrahedra[t].begin(), mesh_.tetrahedra[t].end(), p) !=
            mesh_.tetrahedra[t].end();
        });
    };
    const auto wanted = PrismTets + 1 - tetsAt(point);
    const auto found = std::find_if(end.begin(), end.end(), [&](Index p) { return tetsAt(p) == wanted; });
    return found == end.end() ? None : *found;
  }

  // Are the two prisms between two such pairs of triangles a sound hexahedron?
  bool isHexahedron(const Step& near, const OuterFace& farFirst, const OuterFace& farSecond) const
  {
    const auto& v = near.face[0].corner;
    const auto& w = near.face[1].corner;
    const auto tip = std::find_if(v.begin(), v.end(), [&w](Index p) { return !has(w, p); }) - v.begin();
    const Index other = *std::find_if(w.begin(), w.end(), [&v](Index p) { return !has(v, p); });
    // The triangles are turned away from the pair.
    const std::array<Index, 4> base{ v[tip], v[(tip + 2) % 3], other, v[(tip + 1) % 3] };
    Hexahedron cell{ base[0], base[1], base[2], base[3] };
    for (int i = 0; i < 4; ++i)
    {
      const Index first = has(v, base[i]) ? across(near.group[0], base[i], farFirst.corner) : None;
      const Index second = has(w, base[i]) ? across(near.group[1], base[i], farSecond.corner) : None;
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
    return isSound(cell, mesh_.points);
  }

  // The pairs of prisms that follow one another from a side on, up to where it is closed; nothing if it never is.
  std::optional<std::vector<std::array<Index, 2>>> pairsFrom(Step step) const
  {
    std::vector<std::array<Index, 2>> pairs;
    while (canBeOne(step) && pairs.size() <= members_.size())
    {
      pairs.push_back({ step.group[0], step.group[1] });
      const auto first = opposite(step.group[0], step.face[0].corner);
      const auto second = opposite(step.group[1], step.face[1].corner);
      if (!first || !second || !isHexahedron(step, *first, *second))
      {
        return std::nullopt;
      }
      step = { { *first, *second }, { beyond(first->half), beyond(second->half) } };
    }
    const bool isEnd = isClosed(step) && isQuadrilateral(step.face[0], step.face[1]);
    return isEnd ? std::optional(pairs) : std::nullopt;
  }

  bool canStay(Index g) const
  {
    const std::vector<Step> sides = sidesOf(g);
    const auto isGood = [this](const Step& side) { return isClosed(side) || pairsFrom(side).has_value(); };
    return std::count_if(sides.begin(), sides.end(), isGood) >= 3;
  }

  // Halves that would not have all their sides are parted again, and so on with those beside them.
  void partOthers(std::vector<Halves>& joined)
  {
    for (bool isChanged = true; isChanged;)
    {
      const auto isPoor = [this](const Halves& halves) { return !canStay(halves.two); };
      const auto poor = std::stable_partition(joined.begin(), joined.end(), std::not_fn(isPoor));
      std::for_each(poor, joined.end(), [this](const Halves& halves) { part(halves); });
      isChanged = poor != joined.end();
      joined.erase(poor, joined.end());
    }
  }

  void joinPairsBeyond(Index g)
  {
    for (const Step& side : sidesOf(g))
    {
      const auto pairs = isClosed(side) ? std::nullopt : pairsFrom(side);
      for (const auto& [into, from] : pairs.value_or(std::vector<std::array<Index, 2>>()))
      {
        join(into, from);
      }
    }
  }

  void part(const Halves& halves)
  {
    Members& both = members_[halves.two];
    const Index single = both.tet[2];
    both.count = 2;
    members_[halves.one].add(single);
    groupOf_[single] = halves.one;
  }

  // Have two prisms a quadrilateral in common that has the edge on its border?
  bool areSideBySide(Index a, Index b, const CommonPoints& edge) const
  {
    if (members_[a].count != PrismTets || members_[b].count != PrismTets)
    {
      return false;
    }
    std::vector<Corners> common;
    for (const OuterFace& face : outside(members_[a]))
    {
      if (beyond(face.half) == b)
      {
        common.push_back(face.corner);
      }
    }
    if (common.size() != 2 || CommonPoints(common[0], common[1]).count != 2)
    {
      return false;
    }
    const auto holds = [&edge](const Corners& v) { return has(v, edge.point[0]) && has(v, edge.point[1]); };
    return holds(common[0]) != holds(common[1]); // both: it is the diagonal
  }

  const MeshData& mesh_;
  const FaceMatching& matching_;
  std::vector<Index> groupOf_;
  std::vector<Members> members_; // of each group
};
} // namespace

std::vector<Index> joinPrisms(
  const MeshData& mesh, const FaceMatching& matching, const std::vector<Index>& prism)
{
  return PrismJoiner(mesh, matching, prism).run();
}
} // namespace ransmesh

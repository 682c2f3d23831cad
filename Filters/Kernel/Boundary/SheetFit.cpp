#include "Boundary/SheetFit.h"

#include "Geometry/Predicates.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

namespace ransmesh
{
namespace
{
class Fit
{
public:
  Fit(MeshData& mesh, const std::vector<int>& sheetPatches)
    : mesh_(mesh)
    , same_(mesh.points.size())
  {
    std::iota(same_.begin(), same_.end(), 0);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
      if (std::binary_search(sheetPatches.begin(), sheetPatches.end(), mesh.trianglePatch[i]))
      {
        alone_.push_back(static_cast<Index>(i));
      }
    }
  }

  bool run()
  {
    joinEqualPoints();
    dropPairs();
    while (!alone_.empty())
    {
      if (!joinThirds())
      {
        return false;
      }
      dropPairs();
    }
    return movePoints();
  }

private:
  using Edge = std::pair<Index, Index>;

  Index rootOf(Index v)
  {
    while (same_[v] != v)
    {
      v = same_[v] = same_[same_[v]];
    }
    return v;
  }

  // True if they were two.
  bool join(Index a, Index b)
  {
    a = rootOf(a);
    b = rootOf(b);
    same_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

  void joinEqualPoints()
  {
    std::vector<Index> points;
    for (const Index i : alone_)
    {
      points.insert(points.end(), mesh_.triangles[i].begin(), mesh_.triangles[i].end());
    }
    const auto& p = mesh_.points;
    std::sort(points.begin(), points.end(),
      [&p](Index a, Index b)
      { return std::tie(p[a].x, p[a].y, p[a].z, a) < std::tie(p[b].x, p[b].y, p[b].z, b); });
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      if (p[points[i - 1]] == p[points[i]])
      {
        join(points[i - 1], points[i]);
      }
    }
  }

  // Leaves those triangles alone that have found no partner on the other side.
  void dropPairs()
  {
    std::map<std::array<Index, 3>, Index> waiting;
    for (const Index i : alone_)
    {
      std::array<Index, 3> key = mesh_.triangles[i];
      std::transform(key.begin(), key.end(), key.begin(), [this](Index v) { return rootOf(v); });
      std::sort(key.begin(), key.end());
      const auto [found, isFirst] = waiting.emplace(key, i);
      if (!isFirst)
      {
        waiting.erase(found);
      }
    }
    alone_.clear();
    for (const auto& [key, i] : waiting)
    {
      alone_.push_back(i);
    }
    std::sort(alone_.begin(), alone_.end());
  }

  // Where an edge is known on both sides, the triangles behind it are a pair, and so are their third points.
  // False if there was nothing to join.
  bool joinThirds()
  {
    std::multimap<Edge, std::pair<Index, int>> sides; // of triangles, as they run: number, place of the third
    for (const Index i : alone_)
    {
      for (int third = 0; third < 3; ++third)
      {
        sides.emplace(edgeOf(i, third), std::pair(i, third));
      }
    }
    std::vector<Edge> joins;
    for (const auto& [edge, side] : sides)
    {
      const auto [first, last] = sides.equal_range({ edge.second, edge.first });
      const std::pair<Index, int>* partner = nullptr;
      int partners = 0;
      for (auto other = first; other != last; ++other)
      {
        if (isAcross(side, other->second))
        {
          partner = &other->second;
          ++partners;
        }
      }
      if (partners == 1 && areNear(side, *partner))
      {
        joins.emplace_back(
          mesh_.triangles[side.first][side.second], mesh_.triangles[partner->first][partner->second]);
      }
    }
    bool any = false;
    for (const auto& [a, b] : joins)
    {
      any = join(a, b) || any;
    }
    return any;
  }

  Edge edgeOf(Index triangle, int third)
  {
    const auto& v = mesh_.triangles[triangle];
    return { rootOf(v[(third + 1) % 3]), rootOf(v[(third + 2) % 3]) };
  }

  // Do two triangles at an edge lie on two sides of the sheet? On one side they share both of its points.
  bool isAcross(const std::pair<Index, int>& a, const std::pair<Index, int>& b) const
  {
    const auto& v = mesh_.triangles[a.first];
    const auto& w = mesh_.triangles[b.first];
    return v[(a.second + 1) % 3] != w[(b.second + 2) % 3] || v[(a.second + 2) % 3] != w[(b.second + 1) % 3];
  }

  // Half the way to the edge would be the next level's point.
  bool areNear(const std::pair<Index, int>& a, const std::pair<Index, int>& b) const
  {
    const auto& v = mesh_.triangles[a.first];
    const Vector3& third = mesh_.points[v[a.second]];
    const double room = std::min(distance(third, mesh_.points[v[(a.second + 1) % 3]]),
      distance(third, mesh_.points[v[(a.second + 2) % 3]]));
    return distance(third, mesh_.points[mesh_.triangles[b.first][b.second]]) < 0.5 * room;
  }

  bool movePoints()
  {
    std::vector<std::pair<Index, Vector3>> moved; // with the old places
    std::vector<char> isMoved(mesh_.points.size(), 0);
    for (std::size_t v = 0; v < same_.size(); ++v)
    {
      const Vector3& place = mesh_.points[rootOf(static_cast<Index>(v))];
      if (!(mesh_.points[v] == place))
      {
        moved.emplace_back(static_cast<Index>(v), mesh_.points[v]);
        mesh_.points[v] = place;
        isMoved[v] = 1;
      }
    }
    const bool allowed = moved.empty() ||
      std::all_of(mesh_.tetrahedra.begin(), mesh_.tetrahedra.end(),
        [&](const std::array<Index, 4>& v)
        {
          const auto& p = mesh_.points;
          const bool changed = isMoved[v[0]] || isMoved[v[1]] || isMoved[v[2]] || isMoved[v[3]];
          return !changed || isPositive(p[v[0]], p[v[1]], p[v[2]], p[v[3]]);
        });
    for (const auto& [v, place] : moved)
    {
      mesh_.points[v] = allowed ? mesh_.points[v] : place;
    }
    return allowed;
  }

  MeshData& mesh_;
  std::vector<Index> same_;  // points that are to be one: a point nearer to the root of its tree
  std::vector<Index> alone_; // triangles of sheets without a partner
};
} // namespace

bool fitSheets(MeshData& mesh, const std::vector<int>& sheetPatches)
{
  return Fit(mesh, sheetPatches).run();
}
} // namespace ransmesh

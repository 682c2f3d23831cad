#include "Surface/Welding.h"

#include "Surface/Borders.h"
#include "Triangles/SurfaceEdges.h"
#include "Triangles/SurfaceRepair.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace ransmesh
{
namespace
{
struct NearPair
{
  double distance;
  Index a;
  Index b;
};

// Points of the border in the order of the coordinate in which they spread most: who is near is found in a short run
// of them.
struct SortedBorder
{
  std::vector<Index> points;
  int axis = 0;
};

SortedBorder sortedBorder(const SurfaceMesh& surface)
{
  const std::vector<char> isBorder = borderPoints(surface);
  const auto& p = surface.points;
  SortedBorder border;
  std::vector<Vector3> places;
  for (std::size_t v = 0; v < isBorder.size(); ++v)
  {
    if (isBorder[v])
    {
      border.points.push_back(static_cast<Index>(v));
      places.push_back(p[v]);
    }
  }
  const Extent extent = extentOf(places);
  for (int axis = 1; axis < 3; ++axis)
  {
    border.axis = extent.length(axis) > extent.length(border.axis) ? axis : border.axis;
  }
  std::sort(border.points.begin(), border.points.end(),
    [&p, k = border.axis](Index i, Index j) { return p[i][k] != p[j][k] ? p[i][k] < p[j][k] : i < j; });
  return border;
}

// At each point of the border the length of the shortest open edge there.
std::vector<double> shortestOpenEdges(const SurfaceMesh& surface)
{
  std::vector<double> shortest(surface.points.size(), std::numeric_limits<double>::max());
  forEachEdge(sortedEdges(surface),
    [&](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      if (last - first == 1)
      {
        const double length = distance(surface.points[first->a], surface.points[first->b]);
        shortest[first->a] = std::min(shortest[first->a], length);
        shortest[first->b] = std::min(shortest[first->b], length);
      }
    });
  return shortest;
}

class Welder
{
public:
  explicit Welder(SurfaceMesh& surface)
    : surface_(surface)
    , clusterOf_(surface.points.size())
  {
    std::iota(clusterOf_.begin(), clusterOf_.end(), 0);
    for (const auto& t : surface.triangles)
    {
      for (int i = 0; i < 3; ++i)
      {
        join(t[i], t[(i + 1) % 3]);
      }
    }
  }

  WeldReport run(double tolerance)
  {
    for (const NearPair& pair : nearPairs(tolerance))
    {
      weld(root(pair.a), root(pair.b));
    }
    for (auto& t : surface_.triangles)
    {
      for (Index& v : t)
      {
        v = root(v);
      }
    }
    return report_;
  }

private:
  std::vector<NearPair> nearPairs(double tolerance) const
  {
    const SortedBorder sorted = sortedBorder(surface_);
    const std::vector<Index>& border = sorted.points;
    const int k = sorted.axis;
    const std::vector<double> edge = shortestOpenEdges(surface_);
    const auto& p = surface_.points;
    std::vector<NearPair> pairs;
    for (std::size_t i = 0; i < border.size(); ++i)
    {
      for (std::size_t j = i + 1; j < border.size() && p[border[j]][k] - p[border[i]][k] <= tolerance; ++j)
      {
        const double d = distance(p[border[i]], p[border[j]]);
        if (d <= tolerance && 2 * d < std::min(edge[border[i]], edge[border[j]]))
        {
          pairs.push_back({ d, std::min(border[i], border[j]), std::max(border[i], border[j]) });
        }
      }
    }
    std::sort(pairs.begin(), pairs.end(),
      [](const NearPair& x, const NearPair& y)
      { return std::tie(x.distance, x.a, x.b) < std::tie(y.distance, y.a, y.b); });
    return pairs;
  }

  Index root(Index v) const
  {
    while (clusterOf_[v] != v)
    {
      v = clusterOf_[v];
    }
    return v;
  }

  void join(Index a, Index b) { joined_.insert({ std::min(a, b), std::max(a, b) }); }
  bool areJoined(Index a, Index b) const { return joined_.contains({ std::min(a, b), std::max(a, b) }); }

  // Members of a cluster share no triangle with those of the other.
  bool mayWeld(Index a, Index b) const
  {
    for (const Index x : membersOf(a))
    {
      for (const Index y : membersOf(b))
      {
        if (areJoined(x, y))
        {
          return false;
        }
      }
    }
    return true;
  }

  std::vector<Index> membersOf(Index a) const
  {
    const auto known = members_.find(a);
    return known == members_.end() ? std::vector<Index>{ a } : known->second;
  }

  void weld(Index a, Index b)
  {
    if (a == b || !mayWeld(a, b))
    {
      return;
    }
    const auto [to, from] = std::minmax(a, b);
    report_.where = report_.points == 0 ? surface_.points[to] : report_.where;
    std::vector<Index> members = membersOf(to);
    for (const Index v : membersOf(from))
    {
      members.push_back(v);
      ++report_.points;
      report_.farthest = std::max(report_.farthest, distance(surface_.points[v], surface_.points[to]));
    }
    members_[to] = std::move(members);
    members_.erase(from);
    clusterOf_[from] = to;
  }

  SurfaceMesh& surface_;
  std::vector<Index> clusterOf_;
  std::map<Index, std::vector<Index>> members_; // of clusters of more than one point
  std::set<std::pair<Index, Index>> joined_;    // the edges
  WeldReport report_;
};
} // namespace

WeldReport weldBorders(SurfaceMesh& surface, double tolerance)
{
  const WeldReport report = tolerance > 0 ? Welder(surface).run(tolerance) : WeldReport();
  if (report.points > 0)
  {
    mergeEqualPoints(surface); // drops the points that are not used any more
  }
  return report;
}

double widthOfGaps(const SurfaceMesh& surface)
{
  const SortedBorder sorted = sortedBorder(surface);
  const std::vector<Index>& border = sorted.points;
  const int k = sorted.axis;
  const std::vector<double> edge = shortestOpenEdges(surface);
  const auto& p = surface.points;
  double width = 0;
  for (std::size_t i = 0; i < border.size(); ++i)
  {
    double nearest = edge[border[i]] / 3;
    const auto look = [&](std::size_t j)
    { nearest = std::min(nearest, distance(p[border[i]], p[border[j]])); };
    for (std::size_t j = i + 1; j < border.size() && p[border[j]][k] - p[border[i]][k] < nearest; ++j)
    {
      look(j);
    }
    for (std::size_t j = i; j-- > 0 && p[border[i]][k] - p[border[j]][k] < nearest;)
    {
      look(j);
    }
    width = nearest < edge[border[i]] / 3 ? std::max(width, nearest) : width;
  }
  return width;
}
} // namespace ransmesh

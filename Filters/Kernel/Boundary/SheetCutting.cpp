#include "Boundary/SheetCutting.h"

#include "Boundary/SurfaceEdges.h"

#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace ransmesh
{
namespace
{
// Cuts along one side of the box: what lies beyond, in the direction of sign along the axis, goes.
class SideCut
{
public:
  SideCut(SurfaceMesh& sheets, int axis, double side, double sign, double tolerance)
    : sheets_(sheets)
    , axis_(axis)
    , side_(side)
    , sign_(sign)
  {
    for (Vector3& p : sheets.points)
    {
      p[axis] = std::fabs(p[axis] - side) <= tolerance ? side : p[axis];
    }
  }

  std::size_t run()
  {
    movePointsNearby();
    SurfaceMesh kept;
    std::size_t out = 0;
    for (std::size_t t = 0; t < sheets_.triangles.size(); ++t)
    {
      const std::size_t before = kept.triangles.size();
      out += cut(sheets_.triangles[t], kept.triangles);
      kept.patch.insert(kept.patch.end(), kept.triangles.size() - before, sheets_.patch[t]);
    }
    sheets_.triangles.swap(kept.triangles);
    sheets_.patch.swap(kept.patch);
    return out;
  }

private:
  // Above 0: beyond the side.
  double beyond(Index v) const { return sign_ * (sheets_.points[v][axis_] - side_); }

  // Where the edge passes the side, as a share of it from a, which lies inside, to b, which lies beyond.
  double shareAt(Index a, Index b) const { return beyond(a) / (beyond(a) - beyond(b)); }

  Vector3 placeAt(Index a, Index b) const
  {
    const Vector3& from = sheets_.points[a];
    Vector3 x = from + shareAt(a, b) * (sheets_.points[b] - from);
    x[axis_] = side_;
    return x;
  }

  // Edges at which the sheet ends, branches or changes its patch: their points only move along them.
  void findLines()
  {
    forEachEdge(sortedEdges(sheets_),
      [this](const SurfaceEdge* first, const SurfaceEdge* last)
      {
        const bool isInside =
          last - first == 2 && sheets_.patch[first->triangle] == sheets_.patch[first[1].triangle];
        if (!isInside)
        {
          lines_.insert({ first->a, first->b });
          onLine_[first->a] = onLine_[first->b] = 1;
        }
      });
  }

  // Where v would move to, with the share of the edge that it would move.
  void offer(Index v, Index a, Index b, double share)
  {
    if (onLine_[v] && !lines_.contains(std::minmax(a, b)))
    {
      return;
    }
    const auto [place, isNew] = places_.try_emplace(v, share, placeAt(a, b));
    if (!isNew && share < place->second.first)
    {
      place->second = { share, placeAt(a, b) };
    }
  }

  void movePointsNearby()
  {
    constexpr double near = 0.3;
    onLine_.assign(sheets_.points.size(), 0);
    findLines();
    for (const auto& t : sheets_.triangles)
    {
      for (int i = 0; i < 6; ++i)
      {
        const Index a = t[i % 3];
        const Index b = t[(i < 3 ? i + 1 : i + 2) % 3];
        if (beyond(a) < 0 && beyond(b) > 0)
        {
          const double share = shareAt(a, b);
          share < 0.5 ? offer(a, a, b, share) : offer(b, a, b, 1 - share);
        }
      }
    }
    for (const auto& [v, place] : places_)
    {
      if (place.first < near)
      {
        sheets_.points[v] = place.second;
      }
    }
  }

  Index pointOn(Index a, Index b)
  {
    const Index from = beyond(a) < 0 ? a : b;
    const Index to = from == a ? b : a;
    const auto [point, isNew] = onEdge_.try_emplace({ from, to }, static_cast<Index>(sheets_.points.size()));
    if (isNew)
    {
      const Vector3 x = placeAt(from, to);
      sheets_.points.push_back(x);
    }
    return point->second;
  }

  // Adds what is left of the triangle. True if something of it went.
  bool cut(const std::array<Index, 3>& t, std::vector<std::array<Index, 3>>& kept)
  {
    std::vector<Index> loop;
    bool anyOut = false;
    bool anyIn = false;
    for (int i = 0; i < 3; ++i)
    {
      const Index a = t[i];
      const Index b = t[(i + 1) % 3];
      anyOut = anyOut || beyond(a) > 0;
      anyIn = anyIn || beyond(a) < 0;
      if (beyond(a) <= 0)
      {
        loop.push_back(a);
      }
      if (beyond(a) * beyond(b) < 0)
      {
        loop.push_back(pointOn(a, b));
      }
    }
    if (!anyIn)
    {
      return true;
    }
    const auto& p = sheets_.points;
    const bool otherWay =
      loop.size() == 4 && distance(p[loop[1]], p[loop[3]]) < distance(p[loop[0]], p[loop[2]]);
    const std::size_t first = otherWay ? 1 : 0;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    {
      kept.push_back({ loop[first], loop[(first + i) % loop.size()], loop[(first + i + 1) % loop.size()] });
    }
    return anyOut;
  }

  SurfaceMesh& sheets_;
  int axis_;
  double side_;
  double sign_;
  std::map<std::pair<Index, Index>, Index> onEdge_;
  std::set<std::pair<Index, Index>> lines_;
  std::vector<char> onLine_;                           // of each point
  std::map<Index, std::pair<double, Vector3>> places_; // of points that may move, the nearest, with its share
};
} // namespace

std::size_t cutByBox(SurfaceMesh& sheets, const Extent& box, double tolerance)
{
  std::size_t out = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    out += SideCut(sheets, axis, box.low[axis], -1, tolerance).run();
    out += SideCut(sheets, axis, box.high[axis], 1, tolerance).run();
  }
  return out;
}
} // namespace ransmesh

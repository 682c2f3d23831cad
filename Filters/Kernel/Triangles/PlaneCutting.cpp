#include "Triangles/PlaneCutting.h"

#include "Triangles/SurfaceEdges.h"

#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

namespace ransmesh
{
namespace
{
class PlaneCut
{
public:
  PlaneCut(SurfaceMesh& surface, const AxisPlane& plane, double tolerance, double ridgeAngle)
    : surface_(surface)
    , axis_(plane.axis)
    , place_(plane.place)
    , sign_(plane.keepsAbove ? -1 : 1)
    , smallestCosine_(std::cos(ridgeAngle * std::numbers::pi / 180))
  {
    for (Vector3& p : surface.points)
    {
      p[axis_] = std::fabs(p[axis_] - place_) <= tolerance ? place_ : p[axis_];
    }
  }

  std::size_t run()
  {
    movePointsNearby();
    SurfaceMesh kept;
    std::size_t out = 0;
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
    {
      const std::size_t before = kept.triangles.size();
      out += cut(surface_.triangles[t], kept.triangles);
      kept.patch.insert(kept.patch.end(), kept.triangles.size() - before, surface_.patch[t]);
    }
    surface_.triangles.swap(kept.triangles);
    surface_.patch.swap(kept.patch);
    return out;
  }

private:
  // Above 0: beyond the plane.
  double beyond(Index v) const { return sign_ * (surface_.points[v][axis_] - place_); }

  // Where the edge passes the plane, as a share of it from a, which lies inside, to b, which lies beyond.
  double shareAt(Index a, Index b) const { return beyond(a) / (beyond(a) - beyond(b)); }

  Vector3 placeAt(Index a, Index b) const
  {
    const Vector3& from = surface_.points[a];
    Vector3 x = from + shareAt(a, b) * (surface_.points[b] - from);
    x[axis_] = place_;
    return x;
  }

  bool isRidge(Index s, Index t) const { return dot(normalOf(s), normalOf(t)) < smallestCosine_; }

  Vector3 normalOf(Index t) const
  {
    const auto& v = surface_.triangles[t];
    const auto& p = surface_.points;
    const Vector3 n = cross(p[v[1]] - p[v[0]], p[v[2]] - p[v[0]]);
    const double length = norm(n);
    return length > 0 ? (1 / length) * n : n;
  }

  // Edges at which the surface ends, branches, turns or changes its patch: their points only move along them,
  // and those where other than two of them meet do not move.
  void findLines()
  {
    forEachEdge(sortedEdges(surface_),
      [this](const SurfaceEdge* first, const SurfaceEdge* last)
      {
        const bool isInside = last - first == 2 &&
          surface_.patch[first->triangle] == surface_.patch[first[1].triangle] &&
          !isRidge(first->triangle, first[1].triangle);
        if (!isInside)
        {
          lines_.insert({ first->a, first->b });
          ++linesAt_[first->a];
          ++linesAt_[first->b];
        }
      });
  }

  // Where v would move to, with the share of the edge that it would move.
  void offer(Index v, Index a, Index b, double share)
  {
    if (linesAt_[v] != 0 && (linesAt_[v] != 2 || !lines_.contains(std::minmax(a, b))))
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
    linesAt_.assign(surface_.points.size(), 0);
    findLines();
    for (const auto& t : surface_.triangles)
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
        surface_.points[v] = place.second;
      }
    }
  }

  Index pointOn(Index a, Index b)
  {
    const Index from = beyond(a) < 0 ? a : b;
    const Index to = from == a ? b : a;
    const auto [point, isNew] = onEdge_.try_emplace({ from, to }, static_cast<Index>(surface_.points.size()));
    if (isNew)
    {
      const Vector3 x = placeAt(from, to);
      surface_.points.push_back(x);
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
    const auto& p = surface_.points;
    const bool otherWay =
      loop.size() == 4 && distance(p[loop[1]], p[loop[3]]) < distance(p[loop[0]], p[loop[2]]);
    const std::size_t first = otherWay ? 1 : 0;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    {
      kept.push_back({ loop[first], loop[(first + i) % loop.size()], loop[(first + i + 1) % loop.size()] });
    }
    return anyOut;
  }

  SurfaceMesh& surface_;
  int axis_;
  double place_;
  double sign_;
  double smallestCosine_; // between the normals of triangles that meet at no ridge
  std::map<std::pair<Index, Index>, Index> onEdge_;
  std::set<std::pair<Index, Index>> lines_;
  std::vector<int> linesAt_;                           // how many meet at each point
  std::map<Index, std::pair<double, Vector3>> places_; // of points that may move, the nearest, with its share
};
} // namespace

std::size_t cutByPlane(SurfaceMesh& surface, const AxisPlane& plane, double tolerance, double ridgeAngle)
{
  return PlaneCut(surface, plane, tolerance, ridgeAngle).run();
}
} // namespace ransmesh

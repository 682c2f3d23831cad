#include "Surface/Stitching.h"

#include "Triangles/SurfaceEdges.h"
#include "Triangles/SurfaceTriangles.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace ransmesh
{
namespace
{
constexpr int MostRounds = 3; // one for each side of a triangle
constexpr double ShareOfEdge = 1.0 / 3;

struct OpenEdge
{
  Index from = None; // as its triangle runs
  Index to = None;
  Index triangle = None;
};

std::vector<OpenEdge> openEdges(const SurfaceMesh& surface)
{
  std::vector<OpenEdge> open;
  forEachEdge(sortedEdges(surface),
    [&open](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      if (last - first == 1)
      {
        open.push_back(
          { first->forward ? first->a : first->b, first->forward ? first->b : first->a, first->triangle });
      }
    });
  return open;
}

// The points of the border in the order of the coordinate in which they spread most.
class BorderPoints
{
public:
  BorderPoints(const SurfaceMesh& surface, const std::vector<OpenEdge>& open)
    : points_(surface.points)
  {
    std::vector<Vector3> places;
    for (const OpenEdge& edge : open)
    {
      sorted_.insert(sorted_.end(), { edge.from, edge.to });
      places.push_back(points_[edge.from]);
    }
    const Extent extent = extentOf(places);
    for (int axis = 1; axis < 3; ++axis)
    {
      axis_ = extent.length(axis) > extent.length(axis_) ? axis : axis_;
    }
    std::sort(sorted_.begin(), sorted_.end(),
      [this](Index v, Index w) { return at(v) != at(w) ? at(v) < at(w) : v < w; });
    sorted_.erase(std::unique(sorted_.begin(), sorted_.end()), sorted_.end());
  }

  // Calls visit(point) for all that may lie within the reach of an edge, other than its ends.
  template <class Visit>
  void forEachNear(const OpenEdge& edge, double reach, Visit visit) const
  {
    const auto [low, high] = std::minmax({ at(edge.from), at(edge.to) });
    auto v = std::lower_bound(
      sorted_.begin(), sorted_.end(), low - reach, [this](Index w, double x) { return at(w) < x; });
    for (; v != sorted_.end() && at(*v) <= high + reach; ++v)
    {
      if (*v != edge.from && *v != edge.to)
      {
        visit(*v);
      }
    }
  }

  const std::vector<Index>& all() const { return sorted_; }

private:
  double at(Index v) const { return points_[v][axis_]; }

  const std::vector<Vector3>& points_;
  std::vector<Index> sorted_;
  int axis_ = 0;
};

// Where the foot of p lies on the line from a to b, as a share of it.
double shareOf(const Vector3& p, const Vector3& a, const Vector3& b)
{
  const double square = dot(b - a, b - a);
  return square > 0 ? dot(p - a, b - a) / square : 0;
}

double distanceToEdge(const Vector3& p, const Vector3& a, const Vector3& b)
{
  const double share = std::clamp(shareOf(p, a, b), 0.0, 1.0);
  return distance(p, a + share * (b - a));
}

class Stitcher
{
public:
  Stitcher(SurfaceMesh& surface, double tolerance)
    : surface_(surface)
    , tolerance_(tolerance)
  {
  }

  StitchReport run()
  {
    for (int round = 0; round < MostRounds && runOnce(); ++round)
    {
    }
    return report_;
  }

private:
  // A point to enter an edge.
  struct Stitch
  {
    double share;
    Index point;
    double distance;
  };

  bool runOnce()
  {
    const std::vector<OpenEdge> open = openEdges(surface_);
    const BorderPoints border(surface_, open);
    std::vector<char> isDivided(surface_.triangles.size(), 0);
    for (const OpenEdge& edge : open)
    {
      if (!isDivided[edge.triangle])
      {
        isDivided[edge.triangle] = divide(edge, stitchesOf(edge, border));
      }
    }
    return std::find(isDivided.begin(), isDivided.end(), 1) != isDivided.end();
  }

  Index cornerOpposite(const OpenEdge& edge) const
  {
    const auto& t = surface_.triangles[edge.triangle];
    return *std::find_if(t.begin(), t.end(), [&edge](Index v) { return v != edge.from && v != edge.to; });
  }

  std::vector<Stitch> stitchesOf(const OpenEdge& edge, const BorderPoints& border) const
  {
    const auto& p = surface_.points;
    const Vector3& a = p[edge.from];
    const Vector3& b = p[edge.to];
    const Vector3& far = p[cornerOpposite(edge)];
    const double length = distance(a, b);
    const double height = norm(cross(b - a, far - a)) / length;
    const double reach = std::min({ tolerance_, ShareOfEdge * length, 0.5 * height });
    std::vector<Stitch> stitches;
    border.forEachNear(edge, reach,
      [&](Index v)
      {
        const double share = shareOf(p[v], a, b);
        const double d = distanceToEdge(p[v], a, b);
        if (d <= reach && share > 0 && share < 1 && v != cornerOpposite(edge))
        {
          stitches.push_back({ share, v, d });
        }
      });
    std::sort(stitches.begin(), stitches.end(),
      [](const Stitch& s, const Stitch& t)
      { return std::tie(s.share, s.point) < std::tie(t.share, t.point); });
    return stitches;
  }

  // Parts the edge's triangle by lines from its third corner. False where one of its parts would be turned over.
  bool divide(const OpenEdge& edge, const std::vector<Stitch>& stitches)
  {
    std::vector<Index> chain = { edge.from };
    for (const Stitch& stitch : stitches)
    {
      chain.push_back(stitch.point);
    }
    chain.push_back(edge.to);
    const Index far = cornerOpposite(edge);
    const Vector3 normal = areaVector(surface_, { edge.from, edge.to, far });
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    {
      if (stitches.empty() || dot(areaVector(surface_, { chain[i], chain[i + 1], far }), normal) <= 0)
      {
        return false;
      }
    }
    surface_.triangles[edge.triangle] = { chain[0], chain[1], far };
    for (std::size_t i = 1; i + 1 < chain.size(); ++i)
    {
      surface_.triangles.push_back({ chain[i], chain[i + 1], far });
      surface_.patch.push_back(surface_.patch[edge.triangle]);
    }
    note(stitches);
    return true;
  }

  void note(const std::vector<Stitch>& stitches)
  {
    report_.where = report_.points == 0 ? surface_.points[stitches[0].point] : report_.where;
    report_.points += stitches.size();
    for (const Stitch& stitch : stitches)
    {
      report_.farthest = std::max(report_.farthest, stitch.distance);
    }
  }

  SurfaceMesh& surface_;
  double tolerance_;
  StitchReport report_;
};
} // namespace

StitchReport stitchBorders(SurfaceMesh& surface, double tolerance)
{
  return tolerance > 0 ? Stitcher(surface, tolerance).run() : StitchReport();
}

GapReport closeGaps(SurfaceMesh& surface, double tolerance)
{
  const std::size_t before = openEdges(surface).size();
  if (before == 0 || tolerance <= 0)
  {
    return {};
  }
  SurfaceMesh welded = surface;
  GapReport report;
  report.weld = weldBorders(welded, tolerance);
  SurfaceMesh stitched = welded;
  report.stitch = stitchBorders(stitched, tolerance);
  const std::size_t afterWeld = openEdges(welded).size();
  const std::size_t afterBoth = openEdges(stitched).size();
  if (std::min(afterWeld, afterBoth) >= before)
  {
    return {};
  }
  report.stitch = afterBoth < afterWeld ? report.stitch : StitchReport();
  surface = afterBoth < afterWeld ? std::move(stitched) : std::move(welded);
  return report;
}

double widthOfUnequalGaps(const SurfaceMesh& surface)
{
  const std::vector<OpenEdge> open = openEdges(surface);
  const BorderPoints border(surface, open);
  const auto& p = surface.points;
  std::vector<double> nearest(p.size(), INFINITY);
  for (const OpenEdge& edge : open)
  {
    const double reach = ShareOfEdge * distance(p[edge.from], p[edge.to]);
    border.forEachNear(edge, reach,
      [&](Index v)
      {
        const double d = distanceToEdge(p[v], p[edge.from], p[edge.to]);
        nearest[v] = d < reach ? std::min(nearest[v], d) : nearest[v];
      });
  }
  double width = 0;
  for (const Index v : border.all())
  {
    width = nearest[v] < INFINITY ? std::max(width, nearest[v]) : width;
  }
  return width;
}
} // namespace ransmesh

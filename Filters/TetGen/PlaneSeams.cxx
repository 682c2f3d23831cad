#include "PlaneSeams.h"

#include "PlaneFacet.h"
#include "Worker/RequestParts.h"

#include <algorithm>
#include <map>
#include <optional>

namespace ransmesh
{
namespace
{
class SeamFinder
{
public:
  SeamFinder(const Domain& domain, worker::Request& request)
    : domain_(domain)
    , request_(request)
  {
  }

  PlaneSeam seamOf(std::size_t i, std::size_t j)
  {
    const AxisPlane& p = domain_.planes[i].plane;
    const AxisPlane& q = domain_.planes[j].plane;
    const std::optional<AxisPlane> end = planeAcross(3 - p.axis - q.axis);
    const std::vector<Index> points = pointsOnLine(p, q, end);
    const std::map<Index, bool> isEnd = oddPoints(p);
    PlaneSeam seam;
    bool inFluid = false; // far out, there is none
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      const auto found = isEnd.find(points[k]);
      inFluid = inFluid != (found != isEnd.end() && found->second);
      if (!inFluid)
      {
        continue;
      }
      if (k + 1 < points.size())
      {
        seam.push_back({ points[k], points[k + 1] });
      }
      else if (end && !end->holds(domain_.surface.points[points[k]]))
      {
        seam.push_back({ points[k], corner() });
      }
    }
    for (const auto& [a, b] : seam)
    {
      request_.freeSides.insert(request_.freeSides.end(), { a, b });
    }
    return seam;
  }

private:
  std::optional<AxisPlane> planeAcross(int axis) const
  {
    for (const ClosingPlane& plane : domain_.planes)
    {
      if (plane.plane.axis == axis)
      {
        return plane.plane;
      }
    }
    return std::nullopt;
  }

  // The surface's points where two planes meet, from far out to where a third plane ends the line.
  std::vector<Index> pointsOnLine(
    const AxisPlane& p, const AxisPlane& q, const std::optional<AxisPlane>& end) const
  {
    const auto& points = domain_.surface.points;
    const int along = 3 - p.axis - q.axis;
    const double sign = end && !end->keepsAbove ? 1 : -1;
    std::vector<Index> found;
    for (std::size_t v = 0; v < points.size(); ++v)
    {
      if (p.holds(points[v]) && q.holds(points[v]))
      {
        found.push_back(static_cast<Index>(v));
      }
    }
    std::sort(found.begin(), found.end(),
      [&](Index v, Index w) { return sign * points[v][along] < sign * points[w][along]; });
    return found;
  }

  // Whether a border of the surface ends at a point of the plane.
  std::map<Index, bool> oddPoints(const AxisPlane& plane) const
  {
    std::map<Index, bool> isOdd;
    for (const auto& [a, b] : edgesIn(domain_.surface, domain_.isSheet, plane).borders)
    {
      isOdd[a] = !isOdd[a];
      isOdd[b] = !isOdd[b];
    }
    return isOdd;
  }

  // Where all three planes meet.
  int corner()
  {
    if (corner_ == None)
    {
      Vector3 x;
      for (const ClosingPlane& plane : domain_.planes)
      {
        x[plane.plane.axis] = plane.plane.place;
      }
      corner_ = static_cast<int>(request_.points.size() / 3);
      addPoint(request_, x);
    }
    return corner_;
  }

  const Domain& domain_;
  worker::Request& request_;
  int corner_ = None;
};
} // namespace

std::vector<PlaneSeam> addSeams(const Domain& domain, worker::Request& request)
{
  SeamFinder finder(domain, request);
  std::vector<PlaneSeam> seams(domain.planes.size());
  for (std::size_t i = 0; i < seams.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const PlaneSeam seam = finder.seamOf(i, j);
      seams[i].insert(seams[i].end(), seam.begin(), seam.end());
      seams[j].insert(seams[j].end(), seam.begin(), seam.end());
    }
  }
  return seams;
}
} // namespace ransmesh

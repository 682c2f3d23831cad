#include "DomainRequest.h"

#include "Boundary/SurfaceSizes.h"

#include <algorithm>
#include <set>
#include <utility>

namespace ransmesh
{
namespace
{
void addPolygon(worker::Request& request, const std::vector<int>& corners, int marker)
{
  request.corners.insert(request.corners.end(), corners.begin(), corners.end());
  request.offsets.push_back(static_cast<std::int32_t>(request.corners.size()));
  request.markers.push_back(marker);
}

void addPoint(worker::Request& request, const Vector3& p)
{
  request.points.insert(request.points.end(), { p.x, p.y, p.z });
}

// Adds the box's sides, with what of the surface lies on them.
class BoxWriter
{
public:
  BoxWriter(const SurfaceMesh& surface, const FarFieldBox& box, worker::Request& request)
    : surface_(surface)
    , box_(box)
    , request_(request)
  {
    for (std::size_t v = 0; v < surface.points.size(); ++v)
    {
      if (sidesAt(surface.points[v]) != 0)
      {
        onBox_.push_back(static_cast<Index>(v));
      }
    }
    for (const auto& t : surface.triangles)
    {
      for (int i = 0; i < 3 && !onBox_.empty(); ++i)
      {
        const Index a = t[i];
        const Index b = t[(i + 1) % 3];
        if ((sidesAt(surface.points[a]) & sidesAt(surface.points[b])) != 0)
        {
          edges_.insert({ std::min(a, b), std::max(a, b) });
        }
      }
    }
  }

  void write()
  {
    addCorners();
    for (int side = 0; side < 6; ++side)
    {
      addSide(side);
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        if (!(corner >> axis & 1))
        {
          freeEdge(corner, corner | 1 << axis);
        }
      }
    }
  }

private:
  // A bit for each side of the box that p lies on.
  int sidesAt(const Vector3& p) const
  {
    int sides = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      sides |= (p[axis] == box_.corners[0][axis]) << (2 * axis);
      sides |= (p[axis] == box_.corners[7][axis]) << (2 * axis + 1);
    }
    return sides;
  }

  void addCorners()
  {
    for (int i = 0; i < 8; ++i)
    {
      const auto same = std::find_if(
        onBox_.begin(), onBox_.end(), [&](Index v) { return surface_.points[v] == box_.corners[i]; });
      if (same != onBox_.end())
      {
        corner_[i] = *same;
        continue;
      }
      corner_[i] = static_cast<int>(request_.points.size() / 3);
      addPoint(request_, box_.corners[i]);
    }
  }

  // From one corner to the next: the first, and the surface's points on the way.
  std::vector<int> alongEdge(int from, int to) const
  {
    const Vector3& a = box_.corners[from];
    const Vector3& b = box_.corners[to];
    const int both = sidesAt(a) & sidesAt(b);
    std::vector<int> points;
    for (const Index v : onBox_)
    {
      const int sides = sidesAt(surface_.points[v]);
      if (sides == both)
      {
        points.push_back(v);
      }
    }
    std::sort(points.begin(), points.end(),
      [&](int v, int w) { return dot(surface_.points[v], b - a) < dot(surface_.points[w], b - a); });
    points.insert(points.begin(), corner_[from]);
    return points;
  }

  void addSide(int side)
  {
    std::vector<int> loop;
    for (int i = 0; i < 4; ++i)
    {
      const std::vector<int> points = alongEdge(box_.sides[side][i], box_.sides[side][(i + 1) % 4]);
      loop.insert(loop.end(), points.begin(), points.end());
    }
    const auto polygon = static_cast<std::int32_t>(request_.markers.size());
    addPolygon(request_, loop, box_.patches[side]);
    request_.freeMarkers.push_back(box_.patches[side]);
    for (const auto& [a, b] : edges_)
    {
      const int sides = sidesAt(surface_.points[a]) & sidesAt(surface_.points[b]);
      if (sides == 1 << side) // else it is a part of the loop
      {
        request_.segments.insert(request_.segments.end(), { polygon, a, b });
      }
    }
  }

  void freeEdge(int from, int to)
  {
    std::vector<int> points = alongEdge(from, to);
    points.push_back(corner_[to]);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      const auto [a, b] = std::minmax(points[i], points[i + 1]);
      if (!edges_.contains({ a, b }))
      {
        request_.freeSides.insert(request_.freeSides.end(), { a, b });
      }
    }
  }

  const SurfaceMesh& surface_;
  const FarFieldBox& box_;
  worker::Request& request_;
  std::vector<Index> onBox_;
  std::set<std::pair<Index, Index>> edges_; // of the surface, on the box
  std::array<int, 8> corner_{};
};
} // namespace

worker::Request describeDomain(const SurfaceMesh& surface, const std::optional<FarFieldBox>& box)
{
  worker::Request request;
  for (const Vector3& p : surface.points)
  {
    addPoint(request, p);
  }
  request.offsets.push_back(0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto& v = surface.triangles[t];
    addPolygon(request, { v[0], v[1], v[2] }, surface.patch[t]);
  }
  if (box)
  {
    BoxWriter(surface, *box, request).write();
  }
  return request;
}

void describeSizes(const SurfaceMesh& surface, const SizeLimits& limits, worker::Request& request)
{
  request.maximumSize = limits.maximum;
  request.slope = limits.slope;
  const std::vector<double> sizes = sizesOnSurface(surface, limits.slope);
  for (std::size_t v = 0; v < sizes.size(); ++v)
  {
    const Vector3& p = surface.points[v];
    request.pointSources.insert(request.pointSources.end(), { p.x, p.y, p.z, sizes[v] });
  }
  for (const SizeBox& b : limits.boxes)
  {
    request.boxSources.insert(
      request.boxSources.end(), { b.low.x, b.high.x, b.low.y, b.high.y, b.low.z, b.high.z, b.size });
  }
  for (const SizeSphere& s : limits.spheres)
  {
    request.sphereSources.insert(
      request.sphereSources.end(), { s.centre.x, s.centre.y, s.centre.z, s.radius, s.size });
  }
}
} // namespace ransmesh

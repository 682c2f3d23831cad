#include "BoxFacets.h"

#include "PlaneFacet.h"
#include "Worker/RequestParts.h"

#include <algorithm>
#include <set>
#include <utility>

namespace ransmesh
{
namespace
{
// Adds the box's sides, with what of the surface lies on them.
class BoxWriter
{
public:
  BoxWriter(const Domain& domain, worker::Request& request)
    : domain_(domain)
    , surface_(domain.surface)
    , box_(*domain.box)
    , request_(request)
  {
    for (std::size_t v = 0; v < surface_.points.size(); ++v)
    {
      if (sidesAt(surface_.points[v]) != 0)
      {
        onBox_.push_back(static_cast<Index>(v));
      }
    }
    for (const auto& t : surface_.triangles)
    {
      for (int i = 0; i < 3 && !onBox_.empty(); ++i)
      {
        const Index a = t[i];
        const Index b = t[(i + 1) % 3];
        if ((sidesAt(surface_.points[a]) & sidesAt(surface_.points[b])) != 0)
        {
          edges_.insert({ std::min(a, b), std::max(a, b) });
        }
      }
    }
  }

  Outcome write()
  {
    addCorners();
    for (int side = 0; side < 6; ++side)
    {
      if (Outcome outcome = isPlane(side) ? addPlane(side) : addSide(side); !outcome.ok())
      {
        return outcome;
      }
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
    return Outcome::done();
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

  bool isPlane(int side) const
  {
    return std::any_of(domain_.planes.begin(), domain_.planes.end(),
      [side](const ClosingPlane& plane) { return sideOf(plane.plane) == side; });
  }

  std::vector<int> loopAround(int side) const
  {
    std::vector<int> loop;
    for (int i = 0; i < 4; ++i)
    {
      const std::vector<int> points = alongEdge(box_.sides[side][i], box_.sides[side][(i + 1) % 4]);
      loop.insert(loop.end(), points.begin(), points.end());
    }
    return loop;
  }

  // A corner of the side that lies in no other plane: no body reaches it.
  int freeCorner(int side) const
  {
    for (const int corner : box_.sides[side])
    {
      bool isFree = true;
      for (int axis = 0; axis < 3; ++axis)
      {
        isFree = isFree && (axis == side / 2 || !isPlane(2 * axis + (corner >> axis & 1)));
      }
      if (isFree)
      {
        return corner_[corner];
      }
    }
    return corner_[box_.sides[side][0]];
  }

  Outcome addPlane(int side)
  {
    const Vector3& corner = box_.corners[box_.sides[side][0]];
    const ClosingPlane plane = { { side / 2, corner[side / 2], side % 2 == 0 }, box_.patches[side] };
    PlaneArea area;
    Outcome outcome = addPlaneFacet(plane, edgesIn(surface_, domain_.isSheet, plane.plane),
      PlaneOutline{ loopAround(side), freeCorner(side) }, request_, area);
    for (const auto& [a, b] : area.edges)
    {
      inPlane_.insert(std::minmax(a, b));
    }
    return outcome;
  }

  // Whether the part of the box's edge bounds fluid: not where it lies in a body.
  bool isInFluid(int from, int to, const std::pair<Index, Index>& edge) const
  {
    const int sides = sidesAt(box_.corners[from]) & sidesAt(box_.corners[to]);
    bool touchesPlane = false;
    for (int side = 0; side < 6; ++side)
    {
      touchesPlane = touchesPlane || ((sides >> side & 1) && isPlane(side));
    }
    return !touchesPlane || inPlane_.contains(edge);
  }

  Outcome addSide(int side)
  {
    const auto polygon = static_cast<std::int32_t>(request_.markers.size());
    addPolygon(request_, loopAround(side), box_.patches[side]);
    request_.freeMarkers.push_back(box_.patches[side]);
    for (const auto& [a, b] : edges_)
    {
      const int sides = sidesAt(surface_.points[a]) & sidesAt(surface_.points[b]);
      if (sides == 1 << side) // else it is a part of the loop
      {
        request_.segments.insert(request_.segments.end(), { polygon, a, b });
      }
    }
    return Outcome::done();
  }

  void freeEdge(int from, int to)
  {
    std::vector<int> points = alongEdge(from, to);
    points.push_back(corner_[to]);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      const std::pair<Index, Index> edge = std::minmax(points[i], points[i + 1]);
      if (!edges_.contains(edge) && isInFluid(from, to, edge))
      {
        request_.freeSides.insert(request_.freeSides.end(), { edge.first, edge.second });
      }
    }
  }

  const Domain& domain_;
  const SurfaceMesh& surface_;
  const FarFieldBox& box_;
  worker::Request& request_;
  std::vector<Index> onBox_;
  std::set<std::pair<Index, Index>> edges_;   // of the surface, on the box
  std::set<std::pair<Index, Index>> inPlane_; // edges of the planes' parts
  std::array<int, 8> corner_{};
};
} // namespace

Outcome addBox(const Domain& domain, worker::Request& request)
{
  return BoxWriter(domain, request).write();
}
} // namespace ransmesh

#include "Removal/WallReach.h"

#include "Geometry/Distance.h"
#include "Geometry/TetrahedronMeasures.h"

#include <algorithm>
#include <limits>

namespace ransmesh
{
namespace
{
constexpr double rounding = 1e-9; // so that a ceiling leaves out none that just reaches

double squareOf(const Vector3& a)
{
  return dot(a, a);
}
} // namespace

double limitedThickness(const LayerHeights& heights, double isotropicFraction, double size)
{
  return heights.height(levelsOfIsotropicSize(heights, isotropicFraction, size));
}

WallReach::WallReach(const TetMesh& mesh, const LayerPlan& plan, double margin)
  : mesh_(mesh)
{
  collect(plan);
  linkToVertices();
  findReaches(plan, margin);
  findCeilings();
}

double WallReach::attainableQuality(Index t) const
{
  const WallTriangle& w = triangles_[t];
  const Vector3& a = mesh_.point(w.vertex[0]);
  const Vector3& b = mesh_.point(w.vertex[1]);
  const Vector3& c = mesh_.point(w.vertex[2]);
  const Vector3 top = bounds_[t].centre + bounds_[t].reach * bounds_[t].normal;
  return std::clamp(quality(a, b, c, top), 0.0, 1.0);
}

Index WallReach::approach(const Vector3& p, Index t) const
{
  double best = squareOf(p - bounds_[t].centre);
  for (Index from = None; from != t;)
  {
    from = t;
    for (const Index v : triangles_[from].vertex)
    {
      for (const Index other : at(v))
      {
        const double square = squareOf(p - bounds_[other].centre);
        t = square < best ? other : t;
        best = std::min(best, square);
      }
    }
  }
  return t;
}

Index WallReach::reachingAround(const Vector3& p, Index t) const
{
  if (reaches(p, t))
  {
    return t;
  }
  for (const Index v : triangles_[t].vertex)
  {
    for (const Index other : at(v))
    {
      if (other != t && reaches(p, other))
      {
        return other;
      }
    }
  }
  return None;
}

bool WallReach::isNear(const Vector3& p, Index t) const
{
  const auto& v = triangles_[t].vertex;
  return distanceToTriangle(p, mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2])) <= bounds_[t].reach;
}

void WallReach::collect(const LayerPlan& plan)
{
  for (std::size_t b = 0; b < mesh_.boundarySlots(); ++b)
  {
    const BoundaryFace& face = mesh_.boundaryFace(static_cast<Index>(b));
    const auto patch = static_cast<std::size_t>(face.patch);
    if (face.isAlive() && patch < plan.size() && plan[patch].hasLayers())
    {
      const auto v = mesh_.boundaryVertices(static_cast<Index>(b));
      triangles_.push_back({ v, face.patch, addBounds(v) });
    }
  }
}

// Gives the perimeter.
double WallReach::addBounds(const std::array<Index, 3>& v)
{
  const Vector3& a = mesh_.point(v[0]);
  const Vector3& b = mesh_.point(v[1]);
  const Vector3& c = mesh_.point(v[2]);
  const Vector3 centre = (1.0 / 3) * (a + b + c);
  const double radius = std::max({ distance(centre, a), distance(centre, b), distance(centre, c) });
  bounds_.push_back({ centre, radius, normalized(cross(b - a, c - a)), 0 });
  return distance(a, b) + distance(b, c) + distance(c, a);
}

void WallReach::linkToVertices()
{
  first_.assign(mesh_.vertexCount() + 1, 0);
  for (const WallTriangle& t : triangles_)
  {
    for (const Index v : t.vertex)
    {
      ++first_[v + 1];
    }
  }
  isWall_.resize(mesh_.vertexCount());
  for (std::size_t v = 1; v < first_.size(); ++v)
  {
    isWall_[v - 1] = first_[v] != 0;
    first_[v] += first_[v - 1];
  }
  triangleAt_.resize(3 * triangles_.size());
  std::vector<Index> next(first_.begin(), first_.end() - 1);
  for (std::size_t t = 0; t < triangles_.size(); ++t)
  {
    for (const Index v : triangles_[t].vertex)
    {
      triangleAt_[next[v]++] = static_cast<Index>(t);
    }
  }
}

// The mean edge of the wall triangles at v.
double WallReach::sizeAt(Index v) const
{
  double sum = 0;
  for (const Index t : at(v))
  {
    sum += triangles_[t].perimeter;
  }
  return sum / (3 * (first_[v + 1] - first_[v]));
}

void WallReach::findReaches(const LayerPlan& plan, double margin)
{
  std::vector<LayerHeights> heights;
  for (const LayerSpecification& s : plan)
  {
    heights.emplace_back(s);
  }
  std::vector<double> sizes(mesh_.vertexCount(), 0);
  for (std::size_t v = 0; v < sizes.size(); ++v)
  {
    sizes[v] = isWall(static_cast<Index>(v)) ? sizeAt(static_cast<Index>(v)) : 0;
  }
  for (std::size_t i = 0; i < triangles_.size(); ++i)
  {
    const WallTriangle& t = triangles_[i];
    const double size = std::max({ sizes[t.vertex[0]], sizes[t.vertex[1]], sizes[t.vertex[2]] });
    const double thickness = limitedThickness(heights[t.patch], plan[t.patch].isotropicFraction, size);
    bounds_[i].reach = thickness > 0 ? thickness + margin * size : 0;
    bounds_[i].radius += bounds_[i].reach;
  }
}

void WallReach::findCeilings()
{
  ceiling_.resize(mesh_.vertexCount());
  for (std::size_t i = 0; i < ceiling_.size(); ++i)
  {
    const auto v = static_cast<Index>(i);
    if (isWall(v))
    {
      ceiling_[i] = findCeiling(v);
    }
  }
}

WallReach::Ceiling WallReach::findCeiling(Index v) const
{
  Ceiling ceiling;
  for (const Index t : at(v))
  {
    ceiling.normal += bounds_[t].normal;
  }
  ceiling.normal = normalized(ceiling.normal);
  ceiling.height = -std::numeric_limits<double>::infinity();
  for (const Index t : at(v))
  {
    for (const Index corner : triangles_[t].vertex)
    {
      const double height = dot(mesh_.point(corner), ceiling.normal) + (1 + rounding) * bounds_[t].reach;
      ceiling.height = std::max(ceiling.height, height);
    }
  }
  return ceiling;
}
} // namespace ransmesh

#include "Removal/WallReach.h"

#include "Geometry/Distance.h"
#include "Geometry/TetrahedronMeasures.h"

#include <algorithm>
#include <array>
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

WallReach::WallReach(const TetMesh& mesh, const BoundaryStars& stars, const LayerPlan& plan, double margin)
  : mesh_(mesh)
  , stars_(stars)
{
  collect(plan);
  for (Wall& wall : walls_)
  {
    wall.size /= 3 * wall.triangles;
    wall.ceiling.normal = normalized(wall.ceiling.normal);
  }
  findReaches(plan, margin);
  raiseCeilings();
}

double WallReach::attainableQuality(Index t) const
{
  const auto& v = stars_.verticesOf(t);
  const Vector3& a = mesh_.point(v[0]);
  const Vector3& b = mesh_.point(v[1]);
  const Vector3& c = mesh_.point(v[2]);
  const Vector3 top = bounds_[t].centre + bounds_[t].reach * bounds_[t].normal;
  return std::clamp(quality(a, b, c, top), 0.0, 1.0);
}

Index WallReach::approach(const Vector3& p, Index t) const
{
  double best = squareOf(p - bounds_[t].centre);
  for (Index from = None; from != t;)
  {
    from = t;
    for (const Index v : stars_.verticesOf(from))
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
  for (const Index v : stars_.verticesOf(t))
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
  const auto& v = stars_.verticesOf(t);
  return distanceToTriangle(p, mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2])) <= bounds_[t].reach;
}

void WallReach::collect(const LayerPlan& plan)
{
  bounds_.resize(mesh_.boundarySlots());
  wallNumber_.assign(mesh_.vertexCount(), None);
  for (std::size_t b = 0; b < mesh_.boundarySlots(); ++b)
  {
    const BoundaryFace& face = mesh_.boundaryFace(static_cast<Index>(b));
    const auto patch = static_cast<std::size_t>(face.patch);
    if (face.isAlive() && patch < plan.size() && plan[patch].hasLayers())
    {
      addBounds(static_cast<Index>(b));
    }
  }
}

void WallReach::addBounds(Index face)
{
  const auto& v = stars_.verticesOf(face);
  const Vector3& a = mesh_.point(v[0]);
  const Vector3& b = mesh_.point(v[1]);
  const Vector3& c = mesh_.point(v[2]);
  const Vector3 centre = (1.0 / 3) * (a + b + c);
  const double radius =
    std::sqrt(std::max({ squareOf(centre - a), squareOf(centre - b), squareOf(centre - c) }));
  bounds_[face] = { centre, radius, stars_.normalOf(face), 0 };
  const double perimeter = distance(a, b) + distance(b, c) + distance(c, a);
  for (const Index w : v)
  {
    if (wallNumber_[w] == None)
    {
      wallNumber_[w] = static_cast<Index>(walls_.size());
      walls_.emplace_back();
    }
    Wall& wall = walls_[wallNumber_[w]];
    wall.size += perimeter;
    wall.ceiling.normal += bounds_[face].normal;
    ++wall.triangles;
  }
}

void WallReach::findReaches(const LayerPlan& plan, double margin)
{
  std::vector<LayerHeights> heights;
  for (const LayerSpecification& s : plan)
  {
    heights.emplace_back(s);
  }
  // By patch: a size that leaves all levels, and so does any larger one.
  std::vector<double> leavesAll(plan.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < bounds_.size(); ++i)
  {
    const auto face = static_cast<Index>(i);
    if (!isLayered(face))
    {
      continue;
    }
    const auto& v = stars_.verticesOf(face);
    const int patch = mesh_.boundaryFace(face).patch;
    const double size = std::max({ sizeAt(v[0]), sizeAt(v[1]), sizeAt(v[2]) });
    const double thickness = size >= leavesAll[patch]
      ? heights[patch].thickness()
      : limitedThickness(heights[patch], plan[patch].isotropicFraction, size);
    leavesAll[patch] =
      thickness == heights[patch].thickness() ? std::min(size, leavesAll[patch]) : leavesAll[patch];
    bounds_[i].reach = thickness > 0 ? thickness + margin * size : 0;
    bounds_[i].radius += bounds_[i].reach;
  }
}

// By triangle, each over its own corners: they lie closer to each other in memory than the triangles at a vertex.
void WallReach::raiseCeilings()
{
  for (std::size_t i = 0; i < bounds_.size(); ++i)
  {
    const auto face = static_cast<Index>(i);
    if (!isLayered(face))
    {
      continue;
    }
    const auto& v = stars_.verticesOf(face);
    const std::array<Vector3, 3> corners = { mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]) };
    for (const Index w : v)
    {
      Ceiling& ceiling = walls_[wallNumber_[w]].ceiling;
      for (const Vector3& corner : corners)
      {
        ceiling.height =
          std::max(ceiling.height, dot(corner, ceiling.normal) + (1 + rounding) * bounds_[i].reach);
      }
    }
  }
}
} // namespace ransmesh

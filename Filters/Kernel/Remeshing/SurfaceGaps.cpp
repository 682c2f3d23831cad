#include "Remeshing/SurfaceGaps.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

namespace ransmesh
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;

constexpr double FacingCosine = 0.5;
// Rays start off the surface by this part of their reach, and lean a little from the normal, so that they do
// not run along edges of boxes.
constexpr double StartShare = 1e-3;
constexpr Vector3 Lean{ 1.3e-3, -0.7e-3, 1.9e-3 };

Kernel::Point_3 toCgal(const Vector3& p)
{
  return { p.x, p.y, p.z };
}
} // namespace

class SurfaceGaps::Tree
{
public:
  explicit Tree(const SurfaceMesh& given)
    : given_(given)
  {
    for (const Corners& t : given.triangles)
    {
      triangles_.emplace_back(
        toCgal(given.points[t[0]]), toCgal(given.points[t[1]]), toCgal(given.points[t[2]]));
    }
    tree_.insert(triangles_.cbegin(), triangles_.cend());
    tree_.build();
  }

  bool isInside(const Vector3& p, const Vector3& direction) const
  {
    return tree_.number_of_intersected_primitives(ray(p, direction)) % 2 == 1;
  }

  double facing(const Vector3& p, const Vector3& direction, double reach) const
  {
    const auto hit = tree_.first_intersection(ray(p, direction));
    const Kernel::Point_3* place = hit ? boost::get<Kernel::Point_3>(&hit->first) : nullptr;
    if (!place)
    {
      return INFINITY;
    }
    const Vector3 n = normalized(areaVector(given_, given_.triangles[hit->second - triangles_.cbegin()]));
    const double width = distance(p, { place->x(), place->y(), place->z() });
    return width <= reach && std::fabs(dot(n, direction)) > FacingCosine ? width : INFINITY;
  }

private:
  static Kernel::Ray_3 ray(const Vector3& p, const Vector3& direction)
  {
    return { toCgal(p), Kernel::Vector_3(direction.x, direction.y, direction.z) };
  }

  const SurfaceMesh& given_;
  Triangles triangles_;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree_;
};

SurfaceGaps::SurfaceGaps(const SurfaceMesh& given, GapSide side)
  : side_(side)
  , tree_(new Tree(given))
{
}

SurfaceGaps::~SurfaceGaps() = default;

double SurfaceGaps::widthAt(const EditableSurface& surface, Index v, double reach) const
{
  Vector3 normal;
  for (const Index t : surface.trianglesAt(v))
  {
    normal += areaVector(surface.surface(), surface.triangle(t));
  }
  double width = INFINITY;
  for (const double sign : { 1.0, -1.0 })
  {
    const Vector3 direction = normalized(sign * normalized(normal) + Lean);
    const Vector3 start = surface.point(v) + (StartShare * reach) * direction;
    const double found = tree_->facing(start, direction, reach);
    if (found < INFINITY &&
      (side_ == GapSide::Both || tree_->isInside(start, direction) == (side_ == GapSide::Inside)))
    {
      width = std::min(width, found);
    }
  }
  return width;
}
} // namespace ransmesh

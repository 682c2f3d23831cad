#include "Bodies/RandomParts.h"

#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace bodies
{
namespace
{
using ransmesh::Vector3;
namespace Processing = CGAL::Polygon_mesh_processing;

// The points in order of coordinates, each once, and the triangles in order of points.
void sortAll(ransmesh::SurfaceMesh& surface)
{
  const auto less = [](const Vector3& a, const Vector3& b)
  { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
  std::vector<Vector3> points = surface.points;
  std::sort(points.begin(), points.end(), less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  for (auto& t : surface.triangles)
  {
    for (ransmesh::Index& v : t)
    {
      v = static_cast<ransmesh::Index>(
        std::lower_bound(points.begin(), points.end(), surface.points[v], less) - points.begin());
    }
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  surface.points.swap(points);
  std::sort(surface.triangles.begin(), surface.triangles.end());
}

void addUnlessFlat(Facets& facets, const std::array<std::size_t, 3>& v)
{
  if (v[0] != v[1] && v[1] != v[2] && v[2] != v[0])
  {
    facets.triangles.push_back(v);
  }
}
} // namespace

Vector3 Dice::direction()
{
  const double z = between(-1, 1);
  const double angle = between(0, 2 * M_PI);
  const double r = std::sqrt(1 - z * z);
  return { r * std::cos(angle), r * std::sin(angle), z };
}

Frame randomFrame(Dice& dice)
{
  const Vector3 x = dice.direction();
  const Vector3 z = normalized(cross(x, dice.direction()));
  return { x, cross(z, x), z };
}

Solid solidOf(const Facets& facets)
{
  std::vector<SolidKernel::Point_3> exact;
  for (const Vector3& p : facets.points)
  {
    exact.emplace_back(p.x, p.y, p.z);
  }
  Solid solid;
  Processing::polygon_soup_to_polygon_mesh(exact, facets.triangles, solid);
  return solid;
}

Facets prism(int corners, double a, double b, double height, double taper)
{
  Facets result;
  const auto n = static_cast<std::size_t>(corners);
  const bool isPointed = taper == 0;
  // The tip first, or each lower point with its upper one behind it.
  const auto low = [=](std::size_t i) { return isPointed ? i + 1 : 2 * i; };
  const auto high = [=](std::size_t i) { return isPointed ? 0 : 2 * i + 1; };
  if (isPointed)
  {
    result.points.push_back({ 0, 0, height });
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    const double angle = 2 * M_PI * (static_cast<double>(i) + 0.5) / corners;
    result.points.push_back({ a * std::cos(angle), b * std::sin(angle), -height });
    if (!isPointed)
    {
      result.points.push_back({ taper * a * std::cos(angle), taper * b * std::sin(angle), height });
    }
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t next = (i + 1) % n;
    addUnlessFlat(result, { low(i), low(next), high(next) });
    addUnlessFlat(result, { low(i), high(next), high(i) });
    addUnlessFlat(result, { low(0), low(next), low(i) });
    addUnlessFlat(result, { high(0), high(i), high(next) });
  }
  return result;
}

Facets ball(double radius, std::size_t rings, std::size_t around)
{
  Facets result;
  result.points = { { 0, 0, -radius }, { 0, 0, radius } };
  for (std::size_t k = 1; k <= rings; ++k)
  {
    const double latitude = M_PI * (static_cast<double>(k) / static_cast<double>(rings + 1) - 0.5);
    for (std::size_t i = 0; i < around; ++i)
    {
      const double angle =
        2 * M_PI * (static_cast<double>(i) + 0.5 * static_cast<double>(k)) / static_cast<double>(around);
      result.points.push_back(radius *
        Vector3{
          std::cos(latitude) * std::cos(angle), std::cos(latitude) * std::sin(angle), std::sin(latitude) });
    }
  }
  for (std::size_t i = 0; i < around; ++i)
  {
    const std::size_t next = (i + 1) % around;
    result.triangles.push_back({ 0, 2 + next, 2 + i });
    const std::size_t last = 2 + (rings - 1) * around;
    result.triangles.push_back({ 1, last + i, last + next });
    for (std::size_t k = 0; k + 1 < rings; ++k)
    {
      const std::size_t low = 2 + k * around;
      const std::size_t high = low + around;
      result.triangles.push_back({ low + i, low + next, high + i });
      result.triangles.push_back({ low + next, high + next, high + i });
    }
  }
  return result;
}

void cutByRandomPlane(Dice& dice, Solid& solid)
{
  const Solid before = solid;
  const Vector3 n = dice.upTo(2) == 0 ? Vector3{ 0, 0, 1 } : dice.direction();
  Processing::clip(
    solid, SolidKernel::Plane_3(n.x, n.y, n.z, -dice.between(0.1, 0.6)), CGAL::parameters::clip_volume(true));
  if (solid.number_of_faces() == 0)
  {
    solid = before;
  }
}

ransmesh::SurfaceMesh toSurface(const Solid& solid)
{
  ransmesh::SurfaceMesh surface;
  for (const auto face : solid.faces())
  {
    auto side = solid.halfedge(face);
    const auto first = static_cast<ransmesh::Index>(surface.points.size());
    for (int i = 0; i < 3; ++i)
    {
      const auto p = CGAL::exact(solid.point(solid.target(side)));
      surface.points.push_back({ CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()) });
      side = solid.next(side);
    }
    surface.triangles.push_back({ first, first + 1, first + 2 });
    surface.patch.push_back(1);
  }
  sortAll(surface);
  return surface;
}
} // namespace bodies

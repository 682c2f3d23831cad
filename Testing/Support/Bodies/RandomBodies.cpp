#include "Bodies/RandomBodies.h"

#include "Remeshing/SurfaceRemeshing.h"
#include "Surface/Preparation.h"
#include "Triangles/FeatureSplit.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

namespace bodies
{
namespace
{
using ransmesh::Vector3;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Solid = CGAL::Surface_mesh<Kernel::Point_3>;
namespace Processing = CGAL::Polygon_mesh_processing;

class Dice
{
public:
  explicit Dice(std::uint32_t seed)
    : random_(seed)
  {
  }
  // The library's distributions differ from one standard library to the next; this does not.
  double between(double low, double high) { return low + (high - low) * (random_() / 4294967296.0); }
  int upTo(int count) { return static_cast<int>(random_() % static_cast<std::uint32_t>(count)); }
  Vector3 direction()
  {
    const double z = between(-1, 1);
    const double angle = between(0, 2 * M_PI);
    const double r = std::sqrt(1 - z * z);
    return { r * std::cos(angle), r * std::sin(angle), z };
  }

private:
  std::mt19937 random_;
};

struct Frame
{
  Vector3 x;
  Vector3 y;
  Vector3 z;

  Vector3 operator()(const Vector3& p) const { return p.x * x + p.y * y + p.z * z; }
};

Frame randomFrame(Dice& dice)
{
  const Vector3 x = dice.direction();
  const Vector3 z = normalized(cross(x, dice.direction()));
  return { x, cross(z, x), z };
}

using Corners = std::vector<std::array<std::size_t, 3>>;

Solid solidOf(const std::vector<Vector3>& points, const Corners& triangles)
{
  std::vector<Kernel::Point_3> exact;
  for (const Vector3& p : points)
  {
    exact.emplace_back(p.x, p.y, p.z);
  }
  Solid solid;
  Processing::polygon_soup_to_polygon_mesh(exact, triangles, solid);
  return solid;
}

// The upright body over a polygon of so many corners: a box has four.
std::vector<Vector3> prism(Dice& dice, int corners)
{
  std::vector<Vector3> points;
  const double height = dice.between(0.1, 0.8);
  const double a = dice.between(0.1, 0.6);
  const double b = corners == 4 ? dice.between(0.1, 0.6) : a;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2 * M_PI * (i + 0.5) / corners;
    points.push_back({ a * std::cos(angle), b * std::sin(angle), -height });
    points.push_back({ a * std::cos(angle), b * std::sin(angle), height });
  }
  return points;
}

Corners facesOfPrism(std::size_t corners)
{
  Corners faces;
  for (std::size_t i = 0; i < corners; ++i)
  {
    const std::size_t next = (i + 1) % corners;
    faces.push_back({ 2 * i, 2 * next, 2 * next + 1 });
    faces.push_back({ 2 * i, 2 * next + 1, 2 * i + 1 });
    if (i > 0 && next > 0)
    {
      faces.push_back({ 0, 2 * next, 2 * i });
      faces.push_back({ 1, 2 * i + 1, 2 * next + 1 });
    }
  }
  return faces;
}

// Rings of points around the axis, and the poles.
std::vector<Vector3> ball(Dice& dice, std::size_t rings, std::size_t around)
{
  const double radius = dice.between(0.2, 0.6);
  std::vector<Vector3> points = { { 0, 0, -radius }, { 0, 0, radius } };
  for (std::size_t k = 1; k <= rings; ++k)
  {
    const double latitude = M_PI * (static_cast<double>(k) / static_cast<double>(rings + 1) - 0.5);
    for (std::size_t i = 0; i < around; ++i)
    {
      const double angle =
        2 * M_PI * (static_cast<double>(i) + 0.5 * static_cast<double>(k)) / static_cast<double>(around);
      points.push_back(radius *
        Vector3{
          std::cos(latitude) * std::cos(angle), std::cos(latitude) * std::sin(angle), std::sin(latitude) });
    }
  }
  return points;
}

Corners facesOfBall(std::size_t rings, std::size_t around)
{
  Corners faces;
  for (std::size_t i = 0; i < around; ++i)
  {
    const std::size_t next = (i + 1) % around;
    faces.push_back({ 0, 2 + next, 2 + i });
    const std::size_t last = 2 + (rings - 1) * around;
    faces.push_back({ 1, last + i, last + next });
    for (std::size_t k = 0; k + 1 < rings; ++k)
    {
      const std::size_t low = 2 + k * around;
      const std::size_t high = low + around;
      faces.push_back({ low + i, low + next, high + i });
      faces.push_back({ low + next, high + next, high + i });
    }
  }
  return faces;
}

Solid randomPart(Dice& dice)
{
  const int kind = dice.upTo(3);
  const int corners = kind == 0 ? 4 : 3 + dice.upTo(6);
  constexpr std::size_t rings = 9;
  constexpr std::size_t around = 18;
  std::vector<Vector3> points = kind < 2 ? prism(dice, corners) : ball(dice, rings, around);
  // Half of the parts stand parallel to each other: right angles and common planes are the hard cases.
  const Frame frame = dice.upTo(2) == 0 ? Frame{ { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } : randomFrame(dice);
  const Vector3 place = dice.between(0, 0.5) * dice.direction();
  for (Vector3& p : points)
  {
    p = frame(p) + place;
  }
  return solidOf(
    points, kind < 2 ? facesOfPrism(static_cast<std::size_t>(corners)) : facesOfBall(rings, around));
}

void cut(Dice& dice, Solid& solid)
{
  const Vector3 n = dice.upTo(2) == 0 ? Vector3{ 0, 0, 1 } : dice.direction();
  Processing::clip(
    solid, Kernel::Plane_3(n.x, n.y, n.z, -dice.between(0.1, 0.6)), CGAL::parameters::clip_volume(true));
}

Solid randomSolid(Dice& dice)
{
  Solid solid = randomPart(dice);
  for (int parts = dice.upTo(3); parts > 0; --parts)
  {
    Solid other = randomPart(dice);
    Solid together;
    if (Processing::corefine_and_compute_union(solid, other, together))
    {
      solid = together;
    }
  }
  for (int cuts = dice.upTo(3); cuts > 0; --cuts)
  {
    Solid before = solid;
    cut(dice, solid);
    if (solid.is_empty() || solid.number_of_faces() == 0)
    {
      solid = before;
    }
  }
  solid.collect_garbage();
  return solid;
}

// The points in order of coordinates, and the triangles in order of points: what CGAL gives comes in an order of its
// own each time.
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
} // namespace

RandomBody randomBody(std::uint32_t seed)
{
  Dice dice(seed);
  RandomBody result;
  result.body.patches = { { "fluid", ransmesh::PatchType::Patch },
    { "body_wall", ransmesh::PatchType::Wall } };
  result.size = dice.between(0.06, 0.2);
  result.scale = std::pow(10, dice.between(-3, 6));
  const Frame frame = randomFrame(dice);
  ransmesh::SurfaceMesh surface = toSurface(randomSolid(dice));
  ransmesh::RemeshingOptions options;
  options.length = result.size;
  ransmesh::RemeshingReport report;
  if (!remeshSurface(surface, options, report).ok() ||
    !prepareSurface(surface, result.body.patches, {}, {}).outcome.ok())
  {
    return result;
  }
  if (seed % 2 != 0)
  {
    splitByAngle(surface, result.body.patches, 1, 30);
  }
  for (Vector3& p : surface.points)
  {
    p = result.scale * frame(p);
  }
  result.size *= result.scale;
  result.body.surface = std::move(surface);
  return result;
}
} // namespace bodies

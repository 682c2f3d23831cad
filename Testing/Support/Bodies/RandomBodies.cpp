#include "Bodies/RandomBodies.h"

#include "Boundary/FeatureSplit.h"
#include "Boundary/SurfaceCheck.h"
#include "Boundary/SurfaceRemeshing.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <cmath>
#include <random>

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

Solid hullOf(const std::vector<Vector3>& points)
{
  std::vector<Kernel::Point_3> exact;
  for (const Vector3& p : points)
  {
    exact.emplace_back(p.x, p.y, p.z);
  }
  Solid solid;
  CGAL::convex_hull_3(exact.begin(), exact.end(), solid);
  Processing::triangulate_faces(solid);
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

std::vector<Vector3> ball(Dice& dice)
{
  std::vector<Vector3> points;
  const double radius = dice.between(0.2, 0.6);
  constexpr int count = 200;
  for (int i = 0; i < count; ++i) // a spiral from pole to pole
  {
    const double z = 1 - (2 * i + 1.0) / count;
    const double angle = i * M_PI * (3 - std::sqrt(5.0));
    const double r = std::sqrt(1 - z * z);
    points.push_back(radius * Vector3{ r * std::cos(angle), r * std::sin(angle), z });
  }
  return points;
}

Solid randomPart(Dice& dice)
{
  const int kind = dice.upTo(3);
  std::vector<Vector3> points = kind == 0 ? prism(dice, 4)
    : kind == 1                           ? prism(dice, 3 + dice.upTo(6))
                                          : ball(dice);
  // Half of the parts stand parallel to each other: right angles and common planes are the hard cases.
  const Frame frame = dice.upTo(2) == 0 ? Frame{ { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } : randomFrame(dice);
  const Vector3 place = dice.between(0, 0.5) * dice.direction();
  for (Vector3& p : points)
  {
    p = frame(p) + place;
  }
  return hullOf(points);
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

ransmesh::SurfaceMesh toSurface(const Solid& solid)
{
  ransmesh::SurfaceMesh surface;
  for (const auto v : solid.vertices())
  {
    const auto& p = solid.point(v);
    surface.points.push_back({ CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()) });
  }
  for (const auto face : solid.faces())
  {
    std::array<ransmesh::Index, 3> corners{};
    auto side = solid.halfedge(face);
    for (ransmesh::Index& corner : corners)
    {
      corner = static_cast<ransmesh::Index>(std::size_t(solid.target(side)));
      side = solid.next(side);
    }
    surface.triangles.push_back(corners);
    surface.patch.push_back(1);
  }
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
  if (!remeshSurface(surface, result.size, 30).ok() ||
    !mendAndCheck(surface, result.body.patches).outcome.ok())
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

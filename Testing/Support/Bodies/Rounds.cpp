#include "Bodies/Rounds.h"

#include "Bodies/PlaneFilling.h"

#include <cmath>

namespace bodies
{
namespace
{
constexpr double radiusOfSphere = 0.5;

// With a corner in the direction of x, and one in the other.
std::array<Vector3, 12> icosahedron()
{
  const double g = (1 + std::sqrt(5.0)) / 2;
  std::array<Vector3, 12> corners = { { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 }, { 0, -1, g },
    { 0, 1, g }, { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 }, { -g, 0, -1 }, { -g, 0, 1 } } };
  for (Vector3& p : corners)
  {
    p = (1 / std::hypot(1, g)) * Vector3{ g * p.x - p.z, std::hypot(1, g) * p.y, p.x + g * p.z };
  }
  return corners;
}

constexpr int icosahedronFaces[20][3] = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 },
  { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 }, { 3, 2, 6 },
  { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 }, { 9, 8, 1 } };

void addSphere(SurfaceBuilder& builder, const Vector3& centre, int n, int patch)
{
  const auto corners = icosahedron();
  for (const auto& face : icosahedronFaces)
  {
    const auto at = [&](int i, int j)
    {
      const Vector3 p = static_cast<double>(n - i - j) * corners[face[0]] +
        static_cast<double>(i) * corners[face[1]] + static_cast<double>(j) * corners[face[2]];
      return centre + radiusOfSphere * normalized(p);
    };
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; i + j < n; ++j)
      {
        builder.triangle(at(i, j), at(i + 1, j), at(i, j + 1), patch);
        if (i + j + 1 < n)
        {
          builder.triangle(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), patch);
        }
      }
    }
  }
}

int sphereDivisions(double size)
{
  return divisions(1.15 * radiusOfSphere, size); // the edges of the icosahedron subtend 63 degrees
}

Body anyCone(double size, bool inside, double halfAngle)
{
  constexpr double length = 1;
  const double slope = std::tan(halfAngle * M_PI / 180);
  SurfaceBuilder builder;
  const int side = builder.patch("cone_wall", PatchType::Wall);
  const int base =
    inside ? builder.patch("outlet", PatchType::Outlet) : builder.patch("base_wall", PatchType::Wall);
  const int rows = divisions(length * std::hypot(1, slope), size);
  std::vector<Row> grid;
  for (int i = 0; i <= rows; ++i)
  {
    const double x = length * i / rows;
    grid.push_back(ring(x, slope * x, ringDivisions(slope * x, size)));
  }
  builder.grid(grid, side);
  addDisc(builder, length, slope * length, ringDivisions(slope * length, size), base);
  return builder.finish(!inside);
}
} // namespace

Row ring(double x, double radius, int n)
{
  if (radius <= 0)
  {
    return { { x, 0, 0 } };
  }
  Row row;
  for (int i = 0; i <= n; ++i)
  {
    const double angle = 2 * M_PI * (i % n) / n;
    row.push_back({ x, radius * std::cos(angle), radius * std::sin(angle) });
  }
  return row;
}

int ringDivisions(double radius, double size)
{
  return std::max(6, divisions(2 * M_PI * radius, size));
}

void addDisc(SurfaceBuilder& builder, double x, double radius, int n, int patch)
{
  Loop rim;
  const Row row = ring(x, radius, n);
  for (int i = 0; i < n; ++i)
  {
    rim.push_back({ row[i].y, row[i].z });
  }
  const PlaneTriangles plane = fillPlane({ rim }, 0.1);
  const auto at = [&](int v) { return Vector3{ x, plane.points[v].x, plane.points[v].y }; };
  for (const auto& t : plane.triangles)
  {
    builder.triangle(at(t[0]), at(t[1]), at(t[2]), patch);
  }
}

Body sphere(int n)
{
  SurfaceBuilder builder;
  addSphere(builder, {}, n, builder.patch("sphere", PatchType::Wall));
  return builder.finish(true);
}

Body sphereOfSize(double size)
{
  return sphere(sphereDivisions(size));
}

Body twoSpheres(double size, double gap)
{
  SurfaceBuilder builder;
  const int n = sphereDivisions(size);
  addSphere(builder, {}, n, builder.patch("first_wall", PatchType::Wall));
  addSphere(builder, { 2 * radiusOfSphere + gap, 0, 0 }, n, builder.patch("second_wall", PatchType::Wall));
  return builder.finish(true);
}

Body pipe(double size)
{
  constexpr double radius = 0.5;
  constexpr double length = 2;
  SurfaceBuilder builder;
  const int wall = builder.patch("wall", PatchType::Wall);
  const int ends = builder.patch("symmetry", PatchType::Symmetry);
  const int around = ringDivisions(radius, size);
  const int rows = divisions(length, size);
  std::vector<Row> grid;
  for (int i = 0; i <= rows; ++i)
  {
    grid.push_back(ring(length * i / rows, radius, around));
  }
  builder.grid(grid, wall);
  addDisc(builder, 0, radius, around, ends);
  addDisc(builder, length, radius, around, ends);
  return builder.finish(false);
}

Body cone(double size)
{
  return anyCone(size, false, 20);
}

Body insideOfCone(double size, double halfAngle)
{
  return anyCone(size, true, halfAngle);
}
} // namespace bodies

#include "Bodies/CurvedEnds.h"

#include "Bodies/PlaneFilling.h"
#include "Bodies/Rounds.h"

#include <cmath>
#include <functional>

namespace bodies
{
namespace
{
constexpr double radius = 0.5;

void addFilled(
  SurfaceBuilder& builder, const Loop& rim, int patch, const std::function<Vector3(const PlanePoint&)>& place)
{
  const PlaneTriangles plane = fillPlane({ rim }, 0.1);
  for (const auto& t : plane.triangles)
  {
    builder.triangle(place(plane.points[t[0]]), place(plane.points[t[1]]), place(plane.points[t[2]]), patch);
  }
}
} // namespace

Body cappedPipe(double size)
{
  constexpr double length = 1.5;
  constexpr double bulge = 1.6;
  SurfaceBuilder builder;
  const int wall = builder.patch("wall", PatchType::Wall);
  const int around = ringDivisions(radius, size);
  const int rows = divisions(length, size);
  std::vector<Row> grid;
  for (int i = 0; i <= rows; ++i)
  {
    grid.push_back(ring(length * i / rows, radius, around));
  }
  builder.grid(grid, wall);
  Loop rim;
  for (int i = 0; i < around; ++i)
  {
    rim.push_back({ grid[0][i].y, grid[0][i].z });
  }
  for (const double x : { 0.0, length })
  {
    const int patch =
      x == 0 ? builder.patch("inlet", PatchType::Inlet) : builder.patch("outlet", PatchType::Outlet);
    addFilled(builder, rim, patch,
      [x](const PlanePoint& p)
      {
        const double depth = std::sqrt(bulge * bulge - std::min(radius * radius, p.x * p.x + p.y * p.y)) -
          std::sqrt(bulge * bulge - radius * radius);
        return Vector3{ x - depth, p.x, p.y };
      });
  }
  return builder.finish(false);
}

Body halfDome(double size)
{
  SurfaceBuilder builder;
  const int wall = builder.patch("wall", PatchType::Wall);
  const int dome = builder.patch("dome", PatchType::FarField);
  const int mirror = builder.patch("symmetry", PatchType::Symmetry);
  const int arc = 2 * divisions(M_PI * radius / 2, size);
  std::vector<Row> grid;
  for (int i = 0; i <= arc / 2; ++i)
  {
    const double elevation = M_PI * i / arc;
    const double level = i == arc / 2 ? 0 : radius * std::cos(elevation);
    Row row;
    const int n = divisions(M_PI * level, size);
    for (int j = 0; j <= n; ++j)
    {
      const double angle = M_PI * (static_cast<double>(j) / n - 0.5);
      row.push_back({ level * std::cos(angle), level * std::sin(angle), radius * std::sin(elevation) });
    }
    if (level == 0)
    {
      row.resize(1);
    }
    // Both ends lie in the plane x = 0.
    row.front().x = 0;
    row.back().x = 0;
    grid.push_back(row);
  }
  builder.grid(grid, dome);
  Loop rim;
  for (std::size_t i = 0; i + 1 < grid[0].size(); ++i)
  {
    rim.push_back({ grid[0][i].x, grid[0][i].y });
  }
  appendLine(rim, { 0, radius }, { 0, -radius }, divisions(2 * radius, size));
  addFilled(builder, rim, wall, [](const PlanePoint& p) { return Vector3{ p.x, p.y, 0 }; });
  Loop arch;
  for (int i = 0; i < arc / 2; ++i)
  {
    arch.push_back({ grid[i].front().y, grid[i].front().z });
  }
  for (int i = arc / 2; i > 0; --i)
  {
    arch.push_back({ grid[i].back().y, grid[i].back().z });
  }
  appendLine(arch, { radius, 0 }, { -radius, 0 }, divisions(2 * radius, size));
  addFilled(builder, arch, mirror, [](const PlanePoint& p) { return Vector3{ 0, p.x, p.y }; });
  return builder.finish(false);
}
} // namespace bodies

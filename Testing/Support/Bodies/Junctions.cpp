#include "Bodies/Junctions.h"

#include "Bodies/PlaneFilling.h"
#include "Bodies/Rounds.h"
#include "Bodies/Wings.h"

#include <cmath>

namespace bodies
{
namespace
{
template <class Map>
void addPlane(SurfaceBuilder& builder, const std::vector<Loop>& loops, double growth, int patch, Map map)
{
  const PlaneTriangles plane = fillPlane(loops, growth);
  for (const auto& t : plane.triangles)
  {
    builder.triangle(map(plane.points[t[0]]), map(plane.points[t[1]]), map(plane.points[t[2]]), patch);
  }
}

// The mantle of a cylinder, rolled out, from x = first to x = last, with a seam opposite to the hole.
Loop mantle(double first, double last, double radius, double size)
{
  const int along = divisions(last - first, size);
  const int around = ringDivisions(radius, size);
  const double half = M_PI * radius;
  Loop loop;
  appendLine(loop, { first, -half }, { last, -half }, along);
  appendLine(loop, { last, -half }, { last, half }, around);
  appendLine(loop, { last, half }, { first, half }, along);
  appendLine(loop, { first, half }, { first, -half }, around);
  return loop;
}

// A point of a mantle rolled around the x axis; y = 0 comes to lie in the direction of `up`.
Vector3 rolled(const PlanePoint& p, double radius, const Vector3& up)
{
  const Vector3 side = cross(Vector3{ 1, 0, 0 }, up);
  const double angle = p.y / radius;
  return Vector3{ p.x, 0, 0 } + (radius * std::cos(angle)) * up + (radius * std::sin(angle)) * side;
}

// A round end of the fuselage, from its rim at x to the pole. The first point of the rim is at the seam.
void addHemisphere(
  SurfaceBuilder& builder, double x, double radius, double outward, const Vector3& up, double size, int patch)
{
  const int rows = divisions(M_PI / 2 * radius, size);
  std::vector<Row> grid;
  for (int k = 0; k <= rows; ++k)
  {
    const double latitude = M_PI / 2 * k / rows;
    const double r = k == rows ? 0 : radius * std::cos(latitude);
    const double place = x + outward * radius * std::sin(latitude);
    const int n = r == 0 ? 1 : ringDivisions(r, size);
    Row row;
    for (int i = 0; i <= (r == 0 ? 0 : n); ++i)
    {
      const Vector3 p = rolled({ place, radius * M_PI * (2.0 * (i % n) / n - 1) }, radius, up);
      row.push_back({ place, r / radius * p.y, r / radius * p.z });
    }
    grid.push_back(row);
  }
  builder.grid(grid, patch);
}

// The outline of the room, with the cylinder cut out of it: x and z of each point, and the patch of its edge.
struct Outline
{
  Loop loop;
  std::vector<int> patch;

  void add(const PlanePoint& a, const PlanePoint& b, int n, int patchOfLine)
  {
    appendLine(loop, a, b, n);
    patch.resize(loop.size(), patchOfLine);
  }
};

Outline roomAroundCylinder(SurfaceBuilder& builder, double size, PatchType floorType)
{
  constexpr double radius = 0.5;
  constexpr double reach = 2;
  const int floor = builder.patch("floor", floorType);
  const int wheel = builder.patch("cylinder_wall", PatchType::Wall);
  const int outside = builder.patch("farfield", PatchType::FarField);
  const int n = ringDivisions(radius, size);
  const double half = radius * std::sin(M_PI / n); // of the strip
  const double height = radius * std::cos(M_PI / n);
  const int coarse = divisions(reach, 3 * size);
  Outline outline;
  outline.add({ -reach, 0 }, { -half, 0 }, divisions(reach - half, size), floor);
  for (int i = 0; i < n - 1; ++i) // clockwise, from one end of the strip to the other
  {
    const double angle = M_PI * (2.0 * i + 1) / n;
    outline.loop.push_back({ -radius * std::sin(angle), i == 0 ? 0 : height - radius * std::cos(angle) });
    outline.patch.push_back(wheel);
  }
  outline.add({ half, 0 }, { reach, 0 }, divisions(reach - half, size), floor);
  outline.add({ reach, 0 }, { reach, reach }, coarse, outside);
  outline.add({ reach, reach }, { -reach, reach }, 2 * coarse, outside);
  outline.add({ -reach, reach }, { -reach, 0 }, coarse, outside);
  return outline;
}
} // namespace

Body pipeJunction(double size)
{
  constexpr double radius = 0.5;
  constexpr double branch = 0.3;
  constexpr double reach = 1.25;
  SurfaceBuilder builder;
  const int wall = builder.patch("pipe_wall", PatchType::Wall);
  const int branchWall = builder.patch("branch_wall", PatchType::Wall);
  const int inlet = builder.patch("inlet", PatchType::Inlet);
  const int outlet = builder.patch("outlet", PatchType::Outlet);
  const int n = ringDivisions(branch, size);
  const auto edgeHeight = [&](double angle)
  { return std::sqrt(radius * radius - std::pow(branch * std::sin(angle), 2)); };
  Loop hole;
  Loop sleeve;
  for (int i = 0; i < n; ++i)
  {
    const double angle = 2 * M_PI * i / n;
    hole.push_back({ branch * std::cos(angle), -radius * std::asin(branch * std::sin(angle) / radius) });
    sleeve.push_back({ branch * angle, edgeHeight(angle) });
  }
  const double around = 2 * M_PI * branch;
  const int high = divisions(reach - radius, size);
  appendLine(sleeve, { around, edgeHeight(0) }, { around, reach }, high);
  appendLine(sleeve, { around, reach }, { 0, reach }, n);
  appendLine(sleeve, { 0, reach }, { 0, edgeHeight(0) }, high);
  addPlane(builder, { mantle(-reach, reach, radius, size), hole }, 0.1, wall,
    [&](const PlanePoint& p) {
      return rolled(p, radius, { 0, 0, 1 });
    });
  const auto onBranch = [&](const PlanePoint& p) {
    return Vector3{ branch * std::cos(p.x / branch), branch * std::sin(p.x / branch), p.y };
  };
  addPlane(builder, { sleeve }, 0.1, branchWall, onBranch);
  Loop mouth;
  for (int i = 0; i < n; ++i)
  {
    const Vector3 p = onBranch({ around * i / n, reach });
    mouth.push_back({ p.x, p.y });
  }
  addPlane(builder, { mouth }, 0.1, outlet, [&](const PlanePoint& p) { return Vector3{ p.x, p.y, reach }; });
  for (const double x : { -reach, reach })
  {
    Loop rim;
    const int count = ringDivisions(radius, size);
    for (int i = 0; i < count; ++i)
    {
      const Vector3 p = rolled({ x, M_PI * radius * (2.0 * i / count - 1) }, radius, { 0, 0, 1 });
      rim.push_back({ p.y, p.z });
    }
    addPlane(builder, { rim }, 0.1, x < 0 ? inlet : builder.patch("second_outlet", PatchType::Outlet),
      [x](const PlanePoint& p) {
        return Vector3{ x, p.x, p.y };
      });
  }
  return builder.finish(false);
}

Body wingOnFuselage(double size)
{
  constexpr double radius = 0.3;
  constexpr double first = -0.8;
  constexpr double last = 1.8;
  const Vector3 up = { 0, 1, 0 };
  SurfaceBuilder builder;
  const int fuselage = builder.patch("fuselage_wall", PatchType::Wall);
  const int side = builder.patch("wing_wall", PatchType::Wall);
  const int tip = builder.patch("tip_wall", PatchType::Wall);
  const std::vector<Vector3> section = sectionOf(size, TrailingEdge::Sharp);
  std::vector<double> root;
  Loop hole;
  for (const Vector3& p : section)
  {
    root.push_back(std::sqrt(radius * radius - p.z * p.z));
    hole.push_back({ p.x, radius * std::asin(p.z / radius) });
  }
  constexpr double end = 1.3;
  addWing(builder, section, root, end, size, side);
  addTip(builder, section, end, Tip::Flat, 1, tip);
  addPlane(builder, { mantle(first, last, radius, size), hole }, 0.2, fuselage,
    [&](const PlanePoint& p) { return rolled(p, radius, up); });
  addHemisphere(builder, first, radius, -1, up, size, fuselage);
  addHemisphere(builder, last, radius, 1, up, size, fuselage);
  return builder.finish(true);
}

Body cylinderOnFloor(double size, PatchType floor)
{
  constexpr double width = 0.3;
  SurfaceBuilder builder;
  const Outline outline = roomAroundCylinder(builder, size, floor);
  const int mirror = builder.patch("symmetry", PatchType::Symmetry);
  const int across = divisions(width, size);
  for (std::size_t i = 0; i < outline.loop.size(); ++i)
  {
    const PlanePoint& a = outline.loop[i];
    const PlanePoint& b = outline.loop[(i + 1) % outline.loop.size()];
    builder.strip(straightRow({ a.x, 0, a.y }, { a.x, width, a.y }, across),
      straightRow({ b.x, 0, b.y }, { b.x, width, b.y }, across), outline.patch[i]);
  }
  for (const double y : { 0.0, width })
  {
    addPlane(builder, { outline.loop }, 0.1, mirror,
      [y](const PlanePoint& p) {
        return Vector3{ p.x, y, p.y };
      });
  }
  return builder.finish(false);
}
} // namespace bodies

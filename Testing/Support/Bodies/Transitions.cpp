#include "Bodies/Transitions.h"

#include "Bodies/Lattice.h"

#include <cmath>

namespace bodies
{
namespace
{
bool isNear(double a, double b)
{
  return std::fabs(a - b) < 1e-10;
}

// A box whose bottom's patches are found by bottomAt, with symmetry around and a far field above.
template <class BottomAt>
void addRoom(SurfaceBuilder& builder, const std::array<Axis, 3>& axes, BottomAt bottomAt)
{
  const int around = builder.patch("symmetry", PatchType::Symmetry);
  const int lid = builder.patch("farfield", PatchType::FarField);
  const double height = axes[2].at(axes[2].cells());
  addLattice(builder,
    { axes, {},
      [=](const Vector3& p) { return isNear(p.z, 0)   ? bottomAt(p)
                                : isNear(p.z, height) ? lid
                                                      : around; },
      {} });
}
} // namespace

Body slot(double size, double gap)
{
  SurfaceBuilder builder;
  const int wall = builder.patch("wall", PatchType::Wall);
  const Axis axis({ 0, 0.3, 1 }, size);
  addLattice(builder,
    { { axis, Axis({ 0, 0.5 }, size), Axis({ -0.2, 0, gap, gap + 0.2 }, size) },
      [gap](const Vector3& p) { return p.z < 0 || p.z > gap || p.x < 0.3; },
      [wall](const Vector3&) { return wall; }, {} });
  return builder.finish(true);
}

Body wallOverMirror(double size, double gap)
{
  SurfaceBuilder builder;
  const int wall = builder.patch("wall", PatchType::Wall);
  const int mirror = builder.patch("symmetry", PatchType::Symmetry);
  const int inlet = builder.patch("inlet", PatchType::Inlet);
  const Axis axis({ 0, 1 }, size);
  addLattice(builder,
    { { axis, axis, Axis({ 0, gap }, size) }, {},
      [&](const Vector3& p) { return isNear(p.z, gap) ? wall
                                : isNear(p.z, 0)      ? mirror
                                                      : inlet; }, {} });
  return builder.finish(false);
}

Body wedgeOverMirror(double size)
{
  SurfaceBuilder builder;
  const int wall = builder.patch("wall", PatchType::Wall);
  const int mirror = builder.patch("symmetry", PatchType::Symmetry);
  const int sides = builder.patch("side_symmetry", PatchType::Symmetry);
  const int outlet = builder.patch("outlet", PatchType::Outlet);
  constexpr double width = 0.3;
  const double slope = std::tan(15 * M_PI / 180);
  const int along = divisions(1, size);
  const int across = divisions(width, size);
  // Columns of points from the symmetry plane to the wall, at each x; a single one at the edge.
  const auto upright = [&](int i, double y)
  {
    const double x = static_cast<double>(i) / along;
    return straightRow({ x, y, 0 }, { x, y, slope * x }, i == 0 ? 1 : divisions(slope * x, size));
  };
  std::vector<Row> below;
  std::vector<Row> above;
  for (int i = 0; i <= along; ++i)
  {
    const double x = static_cast<double>(i) / along;
    below.push_back(straightRow({ x, 0, 0 }, { x, width, 0 }, across));
    above.push_back(straightRow({ x, 0, slope * x }, { x, width, slope * x }, across));
  }
  builder.grid(below, mirror);
  builder.grid(above, wall);
  for (const double y : { 0.0, width })
  {
    std::vector<Row> rows{ { { 0, y, 0 } } };
    for (int i = 1; i <= along; ++i)
    {
      rows.push_back(upright(i, y));
    }
    builder.grid(rows, sides);
  }
  std::vector<Row> end;
  for (int k = 0; k <= across; ++k)
  {
    end.push_back(upright(along, width * k / across));
  }
  builder.grid(end, outlet);
  return builder.finish(false);
}

Body twoFloors(double size)
{
  SurfaceBuilder builder;
  const int fore = builder.patch("fore_wall", PatchType::Wall);
  const int aft = builder.patch("aft_wall", PatchType::Wall);
  const Axis half({ 0, 0.5 }, size);
  addRoom(builder, { Axis({ 0, 0.5, 1 }, size), half, half },
    [=](const Vector3& p) { return p.x < 0.5 ? fore : aft; });
  return builder.finish(false);
}

Body endingFloor(double size)
{
  SurfaceBuilder builder;
  const int fore = builder.patch("fore_wall", PatchType::Wall);
  const int slip = builder.patch("slip", PatchType::Patch);
  const Axis half({ 0, 0.5 }, size);
  addRoom(builder, { Axis({ 0, 0.4, 1 }, size), half, half },
    [=](const Vector3& p) { return p.x < 0.4 ? fore : slip; });
  return builder.finish(false);
}

Body floorAndBack(double size)
{
  SurfaceBuilder builder;
  const int floor = builder.patch("floor_wall", PatchType::Wall);
  const int back = builder.patch("back_wall", PatchType::Wall);
  const int sides = builder.patch("symmetry", PatchType::Symmetry);
  const int outside = builder.patch("farfield", PatchType::FarField);
  const Axis axis({ 0, 1 }, size);
  addLattice(builder,
    { { axis, Axis({ 0, 0.5 }, size), axis }, {},
      [=](const Vector3& p)
      {
        return isNear(p.z, 0)                  ? floor
          : isNear(p.x, 0)                     ? back
          : isNear(p.y, 0) || isNear(p.y, 0.5) ? sides
                                               : outside;
      },
      {} });
  return builder.finish(false);
}

Body bulgingDuct(double size)
{
  SurfaceBuilder builder;
  const int wall = builder.patch("walls", PatchType::Wall);
  const int inlet = builder.patch("inlet", PatchType::Inlet);
  const int outlet = builder.patch("outlet", PatchType::Outlet);
  constexpr double half = 0.3;
  constexpr double bulge = 1.6; // the inlet's radius
  const Axis across({ -half, half }, size);
  addLattice(builder,
    { { Axis({ 0, 1 }, size), across, across }, {},
      [=](const Vector3& p) { return isNear(p.x, 0) ? inlet
                                : isNear(p.x, 1)    ? outlet
                                                    : wall; },
      [](const Vector3& p)
      {
        const double depth = std::sqrt(bulge * bulge - p.y * p.y - p.z * p.z) - bulge;
        return Vector3{ p.x - (1 - p.x) * depth, p.y, p.z };
      } });
  return builder.finish(false);
}
} // namespace bodies

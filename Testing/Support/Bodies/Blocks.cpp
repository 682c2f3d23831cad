#include "Bodies/Blocks.h"

#include "Bodies/Lattice.h"

#include <cmath>
#include <random>

namespace bodies
{
namespace
{
bool isNear(double a, double b)
{
  return std::fabs(a - b) < 1e-10;
}

// The four upright sides of the unit square, a symmetry plane each.
class SymmetrySides
{
public:
  explicit SymmetrySides(SurfaceBuilder& builder)
  {
    const char* names[] = { "symmetry_xmin", "symmetry_xmax", "symmetry_ymin", "symmetry_ymax" };
    for (int i = 0; i < 4; ++i)
    {
      patch_[i] = builder.patch(names[i], PatchType::Symmetry);
    }
  }
  int at(const Vector3& p) const
  {
    return patch_[isNear(p.x, 0) ? 0 : isNear(p.x, 1) ? 1 : isNear(p.y, 0) ? 2 : 3];
  }

private:
  std::array<int, 4> patch_{};
};
} // namespace

Body plate(double size, double height, double noise)
{
  SurfaceBuilder builder;
  const int wall = builder.patch("floor", PatchType::Wall);
  const SymmetrySides sides(builder);
  const int lid = builder.patch("farfield", PatchType::FarField);
  addLattice(builder,
    { { Axis({ 0, 1 }, size), Axis({ 0, 1 }, size), Axis({ 0, height }, size) }, {},
      [&](const Vector3& p) { return isNear(p.z, 0)   ? wall
                                : isNear(p.z, height) ? lid
                                                      : sides.at(p); },
      {} });
  Body body = builder.finish(false);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> shift(-noise * size, noise * size);
  for (Vector3& p : body.surface.points)
  {
    if (noise > 0 && isNear(p.z, 0))
    {
      p.z += shift(random);
    }
  }
  return body;
}

Body cavity(double size, bool sixWalls, double angle)
{
  SurfaceBuilder builder;
  const int walls = builder.patch("walls", PatchType::Wall);
  const int sides =
    sixWalls ? builder.patch("lids_wall", PatchType::Wall) : builder.patch("symmetry", PatchType::Symmetry);
  const double cosine = isNear(angle, 90) ? 0 : std::cos(angle * M_PI / 180);
  const double sine = isNear(angle, 90) ? 1 : std::sin(angle * M_PI / 180);
  constexpr double depth = 0.1;
  addLattice(builder,
    { { Axis({ 0, 1 }, size), Axis({ 0, 1 }, size), Axis({ 0, depth }, size) }, {},
      [&](const Vector3& p) { return isNear(p.z, 0) || isNear(p.z, depth) ? sides : walls; },
      [&](const Vector3& p) {
        return Vector3{ p.x + cosine * p.y, sine * p.y, p.z };
      } });
  return builder.finish(false);
}

Body cube(double size)
{
  SurfaceBuilder builder;
  const int wall = builder.patch("cube", PatchType::Wall);
  const Axis axis({ 0, 1 }, size);
  addLattice(builder, { { axis, axis, axis }, {}, [wall](const Vector3&) { return wall; }, {} });
  return builder.finish(true);
}

Body corner(double size)
{
  SurfaceBuilder builder;
  const int wall = builder.patch("walls", PatchType::Wall);
  const int outside = builder.patch("farfield", PatchType::FarField);
  const Axis axis({ 0, 0.5, 1 }, size);
  addLattice(builder,
    { { axis, axis, axis }, [](const Vector3& p) { return p.x > 0.5 || p.y > 0.5 || p.z > 0.5; },
      [&](const Vector3& p) { return isNear(p.x, 1) || isNear(p.y, 1) || isNear(p.z, 1) ? outside : wall; },
      {} });
  return builder.finish(false);
}

Body step(double size)
{
  SurfaceBuilder builder;
  const int floor = builder.patch("floor", PatchType::Wall);
  const int side = builder.patch("symmetry", PatchType::Symmetry);
  const int inlet = builder.patch("inlet", PatchType::Inlet);
  const int outlet = builder.patch("outlet", PatchType::Outlet);
  const int lid = builder.patch("farfield", PatchType::FarField);
  constexpr double width = 0.4;
  constexpr double length = 1.5;
  constexpr double height = 0.75;
  addLattice(builder,
    { { Axis({ 0, 0.5, length }, size), Axis({ 0, width }, size), Axis({ 0, 0.25, height }, size) },
      [](const Vector3& p) { return p.x > 0.5 || p.z > 0.25; },
      [&](const Vector3& p)
      {
        return isNear(p.y, 0) || isNear(p.y, width) ? side
          : isNear(p.z, height)                     ? lid
          : isNear(p.x, 0)                          ? inlet
          : isNear(p.x, length)                     ? outlet
                                                    : floor;
      },
      {} });
  return builder.finish(false);
}

Body groove(double size)
{
  SurfaceBuilder builder;
  const int floor = builder.patch("floor_wall", PatchType::Wall);
  const int sides = builder.patch("groove_wall", PatchType::Wall);
  const int bottom = builder.patch("strip_wall", PatchType::Wall);
  const int lid = builder.patch("farfield", PatchType::FarField);
  const SymmetrySides around(builder);
  constexpr double depth = 0.2;
  const double half = 0.3 * size; // of the width
  addLattice(builder,
    { { Axis({ 0, 0.5 - half, 0.5 + half, 1 }, size), Axis({ 0, 1 }, size), Axis({ -depth, 0, 0.5 }, size) },
      [half](const Vector3& p) { return p.z > 0 || std::fabs(p.x - 0.5) < half; },
      [&](const Vector3& p)
      {
        const bool ends = isNear(p.x, 0) || isNear(p.x, 1) || isNear(p.y, 0) || isNear(p.y, 1);
        return ends             ? around.at(p)
          : isNear(p.z, -depth) ? bottom
          : isNear(p.z, 0.5)    ? lid
          : isNear(p.z, 0)      ? floor
                                : sides;
      },
      {} });
  return builder.finish(false);
}

Body fins(double size)
{
  SurfaceBuilder builder;
  const int floor = builder.patch("floor", PatchType::Wall);
  const int fin = builder.patch("fins", PatchType::Wall);
  const int outside = builder.patch("farfield", PatchType::FarField);
  constexpr double half = 0.025; // of the thickness
  const Axis axis({ -1, -0.5, -half, half, 0.5, 1 }, size);
  addLattice(builder,
    { { axis, axis, Axis({ 0, 0.5, 1 }, size) },
      [](const Vector3& p)
      {
        const double x = std::fabs(p.x);
        const double y = std::fabs(p.y);
        return p.z > 0.5 || x > 0.5 || y > 0.5 || (x > half && y > half);
      },
      [&](const Vector3& p)
      {
        const bool onSide = isNear(std::fabs(p.x), 1) || isNear(std::fabs(p.y), 1) || isNear(p.z, 1);
        return onSide ? outside : isNear(p.z, 0) ? floor : fin;
      },
      {} });
  return builder.finish(false);
}

Body twoPlates(double size, double gap)
{
  SurfaceBuilder builder;
  const int lower = builder.patch("lower_wall", PatchType::Wall);
  const int upper = builder.patch("upper_wall", PatchType::Wall);
  const Axis axis({ 0, 1 }, size);
  addLattice(builder,
    { { axis, axis, Axis({ -0.2, 0, gap, gap + 0.2 }, size) },
      [gap](const Vector3& p) { return p.z < 0 || p.z > gap; },
      [&](const Vector3& p) { return p.z < gap / 2 ? lower : upper; }, {} });
  return builder.finish(true);
}

Body channel(double size, double gap)
{
  SurfaceBuilder builder;
  const int lower = builder.patch("lower_wall", PatchType::Wall);
  const int upper = builder.patch("upper_wall", PatchType::Wall);
  const SymmetrySides sides(builder);
  const Axis axis({ 0, 1 }, size);
  addLattice(builder,
    { { axis, axis, Axis({ 0, gap }, size) }, {},
      [&](const Vector3& p) { return isNear(p.z, 0) ? lower
                                : isNear(p.z, gap)  ? upper
                                                    : sides.at(p); },
      {} });
  return builder.finish(false);
}
} // namespace bodies

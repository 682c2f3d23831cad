#include "Bodies/Sheets.h"

#include "Bodies/Lattice.h"
#include "Bodies/Wings.h"

#include <algorithm>
#include <cmath>

namespace bodies
{
namespace
{
// Between two rows, in rows of this distance.
Body sheetBetween(const Row& first, const Row& last, int rows, const char* name, PatchType type)
{
  SurfaceBuilder builder;
  std::vector<Row> grid;
  for (int k = 0; k <= rows; ++k)
  {
    Row row;
    for (std::size_t i = 0; i < first.size(); ++i)
    {
      row.push_back(k == rows ? last[i] : first[i] + (static_cast<double>(k) / rows) * (last[i] - first[i]));
    }
    grid.push_back(row);
  }
  builder.grid(grid, builder.patch(name, type));
  return builder.finish(false);
}

Body room(double size, PatchType floorType, PatchType elsewhere)
{
  SurfaceBuilder builder;
  const int floor = builder.patch(floorType == PatchType::Wall ? "floor" : "symmetry_floor", floorType);
  const char* names[] = { "xmin", "xmax", "ymin", "ymax", "zmax" };
  std::array<int, 5> sides{};
  for (int i = 0; i < 5; ++i)
  {
    sides[i] = builder.patch(std::string(nameOf(elsewhere)) + "_" + names[i], elsewhere);
  }
  const Axis axis({ 0, 0.25, 0.5, 0.75, 1 }, size);
  const auto isAt = [](double a, double b) { return std::fabs(a - b) < 1e-9; };
  addLattice(builder,
    { { axis, axis, axis }, {},
      [&](const Vector3& p)
      {
        return isAt(p.z, 0) ? floor
          : isAt(p.x, 0)    ? sides[0]
          : isAt(p.x, 1)    ? sides[1]
          : isAt(p.y, 0)    ? sides[2]
          : isAt(p.y, 1)    ? sides[3]
                            : sides[4];
      },
      {} });
  return builder.finish(false);
}

// As many edges as the room's floor has on this length.
int cellsOf(double length, double size)
{
  return static_cast<int>(std::lround(4 * length)) * divisions(0.25, size);
}
} // namespace

Body freeWake(double size)
{
  Body body = room(size, PatchType::Symmetry, PatchType::Symmetry);
  const int n = cellsOf(0.5, size);
  body.sheets.push_back(sheetBetween(straightRow({ 0.25, 0.25, 0.5 }, { 0.25, 0.75, 0.5 }, n),
    straightRow({ 0.75, 0.25, 0.5 }, { 0.75, 0.75, 0.5 }, n), n, "wake", PatchType::Wake));
  return body;
}

Body thinFin(double size)
{
  Body body = room(size, PatchType::Wall, PatchType::FarField);
  const int n = cellsOf(0.5, size);
  body.sheets.push_back(sheetBetween(straightRow({ 0.25, 0.5, 0 }, { 0.75, 0.5, 0 }, n),
    straightRow({ 0.25, 0.5, 0.5 }, { 0.75, 0.5, 0.5 }, n), n, "fin_wall", PatchType::Wall));
  return body;
}

Body wingWithWake(double size)
{
  Body body = wing(size, TrailingEdge::Sharp, Tip::Flat);
  Row edge;
  for (const Vector3& p : body.surface.points)
  {
    if (p.x > 1 - 1e-9)
    {
      edge.push_back(p);
    }
  }
  std::sort(edge.begin(), edge.end(), [](const Vector3& a, const Vector3& b) { return a.y < b.y; });
  Row last = edge;
  for (Vector3& p : last)
  {
    p.x += 1.5;
  }
  body.sheets.push_back(sheetBetween(edge, last, divisions(1.5, size), "wake", PatchType::Wake));
  return body;
}
} // namespace bodies

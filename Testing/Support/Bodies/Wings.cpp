#include "Bodies/Wings.h"

#include "Bodies/Lattice.h"
#include "Bodies/PlaneFilling.h"

#include <algorithm>
#include <cmath>

namespace bodies
{
namespace
{
double halfThickness(double x)
{
  // The last coefficient closes the trailing edge.
  return 0.6 *
    (0.2969 * std::sqrt(x) - 0.1260 * x - 0.3516 * x * x + 0.2843 * x * x * x - 0.1036 * x * x * x * x);
}

bool isBlunt(const std::vector<Vector3>& section)
{
  return section.front().z > 0;
}

// The number of the point below the point i of the upper side.
std::size_t belowOf(const std::vector<Vector3>& section, std::size_t i)
{
  return isBlunt(section) ? section.size() - 1 - i : (section.size() - i) % section.size();
}

// How many edges a blunt trailing edge is high.
int bluntDivisions(const std::vector<Vector3>& section)
{
  return divisions(2 * section.front().z, distance(section[0], section[1]));
}

// Spacings grow from the ends, where they are a third, to the middle.
std::vector<double> spanPlaces(double from, double to, double size, bool fineStart)
{
  const int n = divisions(1.25 * (to - from), size);
  std::vector<double> places;
  for (int i = 0; i <= n; ++i)
  {
    const double s = static_cast<double>(i) / n;
    const double t =
      fineStart ? s - 0.6 * std::sin(2 * M_PI * s) / (2 * M_PI) : s + 0.6 * std::sin(M_PI * s) / M_PI;
    places.push_back(i == n ? to : from + t * (to - from));
  }
  return places;
}

// From the lower to the upper side at the tip.
Row tipRow(const Vector3& upper, const Vector3& lower, double end, double outward, Tip tip, double size)
{
  const double radius = (upper.z - lower.z) / 2;
  const double length = tip == Tip::Flat ? 2 * radius : M_PI * radius;
  if (radius < 1e-12)
  {
    return { { upper.x, end, upper.z } };
  }
  const int n = tip == Tip::Flat ? divisions(length, size) : std::max(2, divisions(length, size));
  Row row = straightRow({ lower.x, end, lower.z }, { upper.x, end, upper.z }, n);
  for (int k = 1; tip == Tip::Round && k < n; ++k)
  {
    const double angle = M_PI * k / n;
    row[k].y = end + outward * radius * std::sin(angle);
    row[k].z = -radius * std::cos(angle);
  }
  return row;
}

// The sides of the box but for the one at y = 0, whose rim comes back as a loop in x and z.
Loop addBox(SurfaceBuilder& builder, const Axis& x, const Axis& y, const Axis& z, int patch)
{
  addLattice(builder,
    { { x, y, z }, {}, [&](const Vector3& p) { return std::fabs(p.y - y.at(0)) < 1e-9 ? 0 : patch; }, {} });
  Loop rim;
  for (int i = 0; i < x.cells(); ++i)
  {
    rim.push_back({ x.at(i), z.at(0) });
  }
  for (int i = 0; i < z.cells(); ++i)
  {
    rim.push_back({ x.at(x.cells()), z.at(i) });
  }
  for (int i = x.cells(); i > 0; --i)
  {
    rim.push_back({ x.at(i), z.at(z.cells()) });
  }
  for (int i = z.cells(); i > 0; --i)
  {
    rim.push_back({ x.at(0), z.at(i) });
  }
  return rim;
}
} // namespace

std::vector<Vector3> sectionOf(double size, TrailingEdge edge)
{
  const double last = edge == TrailingEdge::Sharp ? 1 : 0.97;
  const int n = divisions(1.4, size);
  std::vector<Vector3> upper;
  for (int i = 0; i <= n; ++i) // from the trailing edge to the nose
  {
    const double s = 1 - static_cast<double>(i) / n;
    const double x = last * (0.7 * (1 - std::cos(M_PI * s)) / 2 + 0.3 * s * s);
    upper.push_back({ x, 0, i == n || (i == 0 && edge == TrailingEdge::Sharp) ? 0 : halfThickness(x) });
  }
  std::vector<Vector3> section = upper;
  for (int i = n - 1; i >= (edge == TrailingEdge::Sharp ? 1 : 0); --i)
  {
    section.push_back({ upper[i].x, 0, -upper[i].z });
  }
  return section;
}

void addWing(SurfaceBuilder& builder, const std::vector<Vector3>& section, const std::vector<double>& root,
  double end, double size, int patch)
{
  const bool hasTwoTips = root.empty();
  const std::vector<double> places = spanPlaces(0, 1, size / (hasTwoTips ? 2 * end : end), hasTwoTips);
  const auto row = [&](std::size_t i, double share)
  {
    const Vector3& p = section[i];
    const double first = hasTwoTips ? -end : root[i];
    Row points;
    for (const double s : places)
    {
      points.push_back({ p.x, s == 1 ? end : first + s * (end - first), share * p.z });
    }
    return points;
  };
  std::vector<Row> rows;
  for (std::size_t i = 0; i < section.size(); ++i)
  {
    rows.push_back(row(i, 1));
  }
  if (!isBlunt(section))
  {
    rows.push_back(rows.front());
  }
  builder.grid(rows, patch);
  if (isBlunt(section))
  {
    const int n = bluntDivisions(section);
    std::vector<Row> base;
    for (int k = 0; k <= n; ++k)
    {
      base.push_back(row(0, 1 - 2.0 * k / n));
    }
    builder.grid(base, patch);
  }
}

void addTip(SurfaceBuilder& builder, const std::vector<Vector3>& section, double end, Tip tip, double outward,
  int patch)
{
  const std::size_t n = section.size() / 2; // number of the nose
  std::vector<Row> rows;
  for (std::size_t i = 0; i <= n; ++i)
  {
    const double size = distance(section[i], section[i < n ? i + 1 : i - 1]);
    rows.push_back(tipRow(section[i], section[belowOf(section, i)], end, outward, tip, size));
  }
  builder.grid(rows, patch);
}

Body wing(double size, TrailingEdge edge, Tip tip)
{
  constexpr double end = 0.5;
  SurfaceBuilder builder;
  const int side = builder.patch("wing_wall", PatchType::Wall);
  const int tips = builder.patch("tip_wall", PatchType::Wall);
  const std::vector<Vector3> section = sectionOf(size, edge);
  addWing(builder, section, {}, end, size, side);
  addTip(builder, section, end, tip, 1, tips);
  addTip(builder, section, -end, tip, -1, tips);
  return builder.finish(true);
}

Body halfWing(double size, TrailingEdge edge, Tip tip)
{
  SurfaceBuilder builder;
  const int side = builder.patch("wing_wall", PatchType::Wall);
  const int tips = builder.patch("tip_wall", PatchType::Wall);
  const int mirror = builder.patch("symmetry", PatchType::Symmetry);
  const int outside = builder.patch("farfield", PatchType::FarField);
  const std::vector<Vector3> section = sectionOf(size, edge);
  addWing(builder, section, std::vector<double>(section.size(), 0.0), 1, size, side);
  addTip(builder, section, 1, tip, 1, tips);
  Loop hole;
  for (const Vector3& p : section)
  {
    hole.push_back({ p.x, p.z });
  }
  if (edge == TrailingEdge::Blunt)
  {
    const int n = bluntDivisions(section);
    for (int k = 1; k < n; ++k)
    {
      hole.push_back({ section[0].x, section[0].z * (2.0 * k / n - 1) });
    }
  }
  const Loop rim = addBox(builder, Axis({ -4, 5 }, 1), Axis({ 0, 5 }, 1), Axis({ -4, 4 }, 1), outside);
  const PlaneTriangles plane = fillPlane({ rim, hole }, 0.2);
  const auto at = [&](int v) { return Vector3{ plane.points[v].x, 0, plane.points[v].y }; };
  for (const auto& t : plane.triangles)
  {
    builder.triangle(at(t[0]), at(t[1]), at(t[2]), mirror);
  }
  return builder.finish(false);
}
} // namespace bodies

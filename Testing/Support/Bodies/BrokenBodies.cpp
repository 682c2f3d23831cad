#include "Bodies/BrokenBodies.h"

#include "Bodies/CrossedTriangles.h"
#include "Bodies/CubeSide.h"
#include "Bodies/Rounds.h"
#include "Bodies/Wings.h"

#include "Triangles/SurfaceEdges.h"
#include "Triangles/SurfaceRepair.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace bodies
{
namespace
{
using ransmesh::Index;
using ransmesh::PatchType;
using ransmesh::SurfaceFault;
using ransmesh::SurfaceMesh;
using ransmesh::Vector3;
using End = BrokenBody::End;

constexpr int Divisions = 4;

// The cube [-1, 1]^3, each side a patch of 2 n^2 triangles, turned outward.
Body cube(int n = Divisions)
{
  Body body;
  body.farField = true;
  body.patches = { { "fluid", PatchType::Patch } };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int side : { -1, 1 })
    {
      body.patches.push_back({ std::string(side < 0 ? "low_" : "high_") + "xyz"[axis], PatchType::Wall });
      addCubeSide(axis, side > 0, n, static_cast<int>(body.patches.size()) - 1, body.surface);
    }
  }
  ransmesh::mergeEqualPoints(body.surface);
  return body;
}

Body ball()
{
  Body body = cube();
  for (Vector3& p : body.surface.points)
  {
    p = (1 / norm(p)) * p;
  }
  return body;
}

Body moved(Body body, const Vector3& by, double scale = 1)
{
  for (Vector3& p : body.surface.points)
  {
    p = scale * p + by;
  }
  return body;
}

// Both, with patches of their own.
Body together(Body a, const Body& b)
{
  const auto firstPoint = static_cast<Index>(a.surface.points.size());
  const int firstPatch = static_cast<int>(a.patches.size()) - 1;
  a.surface.points.insert(a.surface.points.end(), b.surface.points.begin(), b.surface.points.end());
  for (std::size_t t = 0; t < b.surface.triangles.size(); ++t)
  {
    const auto& v = b.surface.triangles[t];
    a.surface.triangles.push_back({ v[0] + firstPoint, v[1] + firstPoint, v[2] + firstPoint });
    a.surface.patch.push_back(b.surface.patch[t] + firstPatch);
  }
  for (std::size_t i = 1; i < b.patches.size(); ++i)
  {
    a.patches.push_back({ "other_" + b.patches[i].name, b.patches[i].type });
  }
  return a;
}

std::set<Index> triangleRange(Index from, Index to)
{
  std::set<Index> all;
  for (Index t = from; t < to; ++t)
  {
    all.insert(t);
  }
  return all;
}

std::set<Index> trianglesAt(const SurfaceMesh& s, Index v)
{
  std::set<Index> all;
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
  {
    if (std::count(s.triangles[t].begin(), s.triangles[t].end(), v) > 0)
    {
      all.insert(static_cast<Index>(t));
    }
  }
  return all;
}

Index pointAt(const SurfaceMesh& s, const Vector3& place)
{
  const auto isThere = [&place](const Vector3& p) { return distance(p, place) < 1e-12; };
  return static_cast<Index>(std::find_if(s.points.begin(), s.points.end(), isThere) - s.points.begin());
}

std::set<Index> trianglesAtEdge(const SurfaceMesh& s, const Vector3& from, const Vector3& to)
{
  const std::set<Index> atFrom = trianglesAt(s, pointAt(s, from));
  const std::set<Index> atTo = trianglesAt(s, pointAt(s, to));
  std::set<Index> both;
  std::set_intersection(
    atFrom.begin(), atFrom.end(), atTo.begin(), atTo.end(), std::inserter(both, both.end()));
  return both;
}

std::set<Index> trianglesAtOpenEdges(const SurfaceMesh& s)
{
  std::set<Index> all;
  ransmesh::forEachEdge(ransmesh::sortedEdges(s),
    [&all](const ransmesh::SurfaceEdge* first, const ransmesh::SurfaceEdge* last)
    {
      if (last - first == 1)
      {
        all.insert(first->triangle);
      }
    });
  return all;
}

// The triangles of which `goes` says so are left out.
template <class Goes>
Body without(Body body, Goes goes)
{
  std::vector<char> stays;
  for (std::size_t t = 0; t < body.surface.triangles.size(); ++t)
  {
    stays.push_back(!goes(static_cast<Index>(t)));
  }
  ransmesh::keepTriangles(body.surface, stays);
  return body;
}

void addDropped(std::vector<BrokenBody>& all)
{
  const auto add = [&all](const std::string& name, const Body& body, std::size_t count)
  {
    all.push_back({ "dropped-" + name, body, SurfaceFault::OpenEdge, count,
      trianglesAtOpenEdges(body.surface), true, End::Filled });
  };
  add("one", without(ball(), [](Index t) { return t == 37; }), 3);
  add("neighbours", without(ball(), [](Index t) { return t == 38 || t == 39; }), 4);
  add("far-apart", without(ball(), [](Index t) { return t == 10 || t == 150; }), 6);
  add("corner", without(cube(), [](Index t) { return t == 0; }), 3);
  add("side", without(cube(), [](Index t) { return t < 2 * Divisions * Divisions; }), 4 * Divisions);
}

void addDuplicates(std::vector<BrokenBody>& all)
{
  const auto add = [&all](const std::string& name, Body body, const std::vector<Index>& which, bool turned)
  {
    SurfaceMesh& s = body.surface;
    std::set<Index> marks(which.begin(), which.end());
    for (const Index t : which)
    {
      const auto& v = s.triangles[t];
      marks.insert(static_cast<Index>(s.triangles.size()));
      s.triangles.push_back(turned ? std::array{ v[1], v[0], v[2] } : std::array{ v[1], v[2], v[0] });
      s.patch.push_back(s.patch[t]);
    }
    all.push_back(
      { "duplicate-" + name, body, SurfaceFault::Duplicate, which.size(), marks, true, End::Meshed });
  };
  add("one", ball(), { 20 }, false);
  add("turned", ball(), { 20 }, true);
  add("several", cube(), { 1, 2, 3, 50, 51, 100 }, false);
  const std::set<Index> whole = triangleRange(0, 12 * Divisions * Divisions);
  add("whole", ball(), { whole.begin(), whole.end() }, false);
}

void addFlipped(std::vector<BrokenBody>& all)
{
  const auto add = [&all](const std::string& name, Body body, const std::set<Index>& which, std::size_t edges)
  {
    for (const Index t : which)
    {
      std::swap(body.surface.triangles[t][0], body.surface.triangles[t][1]);
    }
    all.push_back({ "flipped-" + name, body, SurfaceFault::Turned, edges, which, true, End::Meshed });
  };
  add("one", ball(), { 33 }, 3);
  add("three", cube(), { 5, 77, 180 }, 9);
  add("side", cube(), triangleRange(0, 2 * Divisions * Divisions), 4 * Divisions);
}

// A triangle with points of its own, beside its place.
void addShifted(std::vector<BrokenBody>& all)
{
  const auto add = [&all](const std::string& name, double by, End end)
  {
    Body body = ball();
    SurfaceMesh& s = body.surface;
    const auto corners = s.triangles[40];
    for (int i = 0; i < 3; ++i)
    {
      s.points.push_back((1 + by) * s.points[corners[i]]);
      s.triangles[40][i] = static_cast<Index>(s.points.size()) - 1;
    }
    all.push_back({ "shifted-" + name, body, SurfaceFault::OpenEdge, 6, trianglesAtOpenEdges(s), true, end });
  };
  add("far", 0.3, End::Wrapped);
  add("near", 1e-3, End::Welded);
  add("nearly", 1e-8, End::Meshed);
}

void addNotFinite(std::vector<BrokenBody>& all)
{
  const auto add = [&all](const std::string& name, double value)
  {
    Body body = ball();
    body.surface.points[17].y = value;
    all.push_back({ "coordinate-" + name, body, SurfaceFault::NotFinite, 1, trianglesAt(body.surface, 17),
      true, End::Refused });
  };
  add("nan", std::numeric_limits<double>::quiet_NaN());
  add("infinite", std::numeric_limits<double>::infinity());
  add("huge", 1e100);
}

// The ball in two halves with a gap between them.
void addGaps(std::vector<BrokenBody>& all)
{
  for (int power = 2; power <= 8; ++power)
  {
    Body body = ball();
    SurfaceMesh& s = body.surface;
    std::vector<Index> copy(s.points.size(), ransmesh::None);
    for (auto& t : s.triangles)
    {
      if (s.points[t[0]].z + s.points[t[1]].z + s.points[t[2]].z < 0)
      {
        continue;
      }
      for (Index& v : t)
      {
        if (copy[v] == ransmesh::None)
        {
          copy[v] = static_cast<Index>(s.points.size());
          s.points.push_back(s.points[v] + Vector3{ 0, 0, 2 * std::pow(10, -power) });
        }
        v = copy[v];
      }
    }
    ransmesh::mergeEqualPoints(s);
    const End end = power >= 7 ? End::Meshed : power == 6 ? End::MeshedOrRefused : End::Welded;
    all.push_back({ "gap-1e-" + std::to_string(power), body, SurfaceFault::OpenEdge, 8 * Divisions,
      trianglesAtOpenEdges(s), true, end });
  }
}

void addCrossings(std::vector<BrokenBody>& all)
{
  const auto add = [&all](const std::string& name, const Body& body, bool onlyCrosses = true)
  {
    all.push_back({ "crossing-" + name, body, SurfaceFault::Intersection, 0, crossedTriangles(body.surface),
      onlyCrosses, End::Wrapped });
  };
  add("balls", together(ball(), moved(ball(), { 0.9, 0.1, 0.05 })));
  add("ball-and-cube", together(cube(), moved(ball(), { 1.03, 0.13, 0.07 }, 0.5)));
  Body beam = cube(1);
  for (Vector3& p : beam.surface.points)
  {
    p = { 1.7 * p.x + 0.03, 0.3 * p.y + 0.07, 0.3 * p.z };
  }
  add("beam", together(ball(), beam));
  add("sides-overlap", together(cube(), moved(cube(), { 2, 0.3, 0.2 })), false); // others touch

  Body pierced = ball();
  pierced.surface.points[30] = -1.4 * pierced.surface.points[30] + Vector3{ 0.05, 0.03, 0.02 };
  add("point-through-the-ball", pierced);
  Body cornered = cube();
  cornered.surface.points[0] = { 1.2, 0.9, 1.1 };
  add("point-through-the-cube", cornered);
}

void addTouching(std::vector<BrokenBody>& all)
{
  Body edge = together(cube(1), moved(cube(1), { 2, 2, 0 }));
  ransmesh::mergeEqualPoints(edge.surface);
  all.push_back({ "touching-in-an-edge", edge, SurfaceFault::NonManifoldEdge, 1,
    trianglesAtEdge(edge.surface, { 1, 1, -1 }, { 1, 1, 1 }), true, End::Meshed });
  Body point = together(cube(1), moved(cube(1), { 2, 2, 2 }));
  ransmesh::mergeEqualPoints(point.surface);
  all.push_back({ "touching-in-a-point", point, SurfaceFault::NonManifoldPoint, 1,
    trianglesAt(point.surface, pointAt(point.surface, { 1, 1, 1 })), true, End::Meshed });
  const Body near = together(cube(), moved(cube(), { 2 + 1e-7, 0, 0 }));
  all.push_back({ "near-sheets", near, SurfaceFault::NearSheets, 0,
    triangleRange(2 * Divisions * Divisions, 4 * Divisions * Divisions), false, End::MeshedOrRefused });
}

void addDegenerate(std::vector<BrokenBody>& all)
{
  // A point in the middle of an edge that only one of the triangles there knows: one flat triangle fills the rest.
  Body flat = cube(1);
  SurfaceMesh& s = flat.surface;
  const auto t = s.triangles[0];
  const auto middle = static_cast<Index>(s.points.size());
  s.points.push_back(0.5 * (s.points[t[0]] + s.points[t[1]]));
  s.triangles[0] = { t[0], middle, t[2] };
  s.triangles.push_back({ middle, t[1], t[2] });
  s.triangles.push_back({ t[0], t[1], middle });
  s.patch.insert(s.patch.end(), 2, s.patch[0]);
  all.push_back({ "degenerate-flat", flat, SurfaceFault::Degenerate, 1,
    { static_cast<Index>(s.triangles.size()) - 1 }, true, End::Meshed });
  Body collapsed = ball();
  collapsed.surface.triangles.push_back({ 3, 3, 8 });
  collapsed.surface.patch.push_back(1);
  all.push_back({ "degenerate-collapsed", collapsed, SurfaceFault::Degenerate, 1,
    { static_cast<Index>(collapsed.surface.triangles.size()) - 1 }, true, End::Meshed });
}

// The triangle whose middle comes nearest to a place.
Index triangleNear(const SurfaceMesh& s, const Vector3& place)
{
  Index best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
  {
    const auto& v = s.triangles[t];
    const Vector3 middle = (1.0 / 3) * (s.points[v[0]] + s.points[v[1]] + s.points[v[2]]);
    if (distance(middle, place) < least)
    {
      least = distance(middle, place);
      best = static_cast<Index>(t);
    }
  }
  return best;
}

// A triangle dropped, duplicated, turned, not finite, and a point moved through the opposite wall, where the body is
// sharp or thin.
void addSharp(const std::string& name, const Body& body, const Vector3& place, const Vector3& away,
  std::vector<BrokenBody>& all)
{
  const Index t = triangleNear(body.surface, place);
  const Body dropped = without(body, [t](Index other) { return other == t; });
  all.push_back({ "dropped-" + name, dropped, SurfaceFault::OpenEdge, 3,
    trianglesAtOpenEdges(dropped.surface), true, End::Filled });
  Body twice = body;
  const auto last = static_cast<Index>(twice.surface.triangles.size());
  twice.surface.triangles.push_back(twice.surface.triangles[t]);
  twice.surface.patch.push_back(twice.surface.patch[t]);
  all.push_back({ "duplicate-" + name, twice, SurfaceFault::Duplicate, 1, { t, last }, true, End::Meshed });
  Body turned = body;
  std::swap(turned.surface.triangles[t][0], turned.surface.triangles[t][1]);
  all.push_back({ "flipped-" + name, turned, SurfaceFault::Turned, 3, { t }, true, End::Meshed });
  const Index v = body.surface.triangles[t][0];
  Body missing = body;
  missing.surface.points[v].x = std::numeric_limits<double>::quiet_NaN();
  all.push_back({ "coordinate-" + name, missing, SurfaceFault::NotFinite, 1, trianglesAt(missing.surface, v),
    true, End::Refused });
  Body pierced = body;
  pierced.surface.points[v] = pierced.surface.points[v] + away;
  all.push_back({ "crossing-point-through-the-" + name, pierced, SurfaceFault::Intersection, 0,
    crossedTriangles(pierced.surface), true, End::Wrapped });
}

void addSharpBodies(std::vector<BrokenBody>& all)
{
  addSharp("wing", wing(0.1, TrailingEdge::Sharp, Tip::Flat), { 0.5, 0.5, 0.06 }, { 0, 0, -0.2 }, all);
  addSharp("cone", cone(0.15), { 0, 0, 0 }, { 0.4, 0.3, 0.1 }, all);
}
} // namespace

std::vector<BrokenBody> brokenBodies()
{
  std::vector<BrokenBody> all;
  for (const auto add : { addDropped, addDuplicates, addFlipped, addShifted, addNotFinite, addGaps,
         addCrossings, addTouching, addDegenerate, addSharpBodies })
  {
    add(all);
  }
  return all;
}
} // namespace bodies

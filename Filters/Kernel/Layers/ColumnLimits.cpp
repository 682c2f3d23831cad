#include "Layers/ColumnLimits.h"

#include "Geometry/Predicates.h"
#include "Mesh/Traversal.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace ransmesh
{
namespace
{
constexpr double LargestSlope = 1.0;
// Rays lean by a thousandth into an odd direction, so that they do not run along the mesh's own edges.
constexpr Vector3 RayLean{ 0.00053, -0.00031, 0.00079 };

// Follows a ray from a vertex through the mesh.
class RayWalk
{
public:
  explicit RayWalk(const TetMesh& mesh)
    : mesh_(mesh)
    , traversal_(mesh)
  {
  }

  // The distance along the unit vector d at which the ray from v leaves the mesh, or reach if it is
  // still inside there. A ray that cannot be followed counts as free.
  double freeDistance(Index v, const Vector3& d, double reach)
  {
    const Vector3 from = mesh_.point(v);
    HalfFace exit = firstExit(v, d);
    for (int steps = 0; steps < 10000 && exit != None; ++steps)
    {
      const double s = distanceTo(exit, from, d);
      if (s >= reach)
      {
        return reach;
      }
      const HalfFace beyond = mesh_.tet(tetOf(exit)).neighbour[faceOf(exit)];
      if (isBoundary(beyond))
      {
        return s;
      }
      exit = exitFrom(beyond, from, d);
    }
    return reach;
  }

private:
  // Does the ray pass the three edges of the face, seen from outside, on the same side?
  bool passes(const std::array<Index, 3>& face, const Vector3& from, const Vector3& d) const
  {
    const Vector3 a = mesh_.point(face[0]) - from;
    const Vector3 b = mesh_.point(face[1]) - from;
    const Vector3 c = mesh_.point(face[2]) - from;
    // The corners are turned inward: seen along a ray that leaves, they are clockwise.
    return dot(cross(b, a), d) >= 0 && dot(cross(c, b), d) >= 0 && dot(cross(a, c), d) >= 0;
  }
  HalfFace firstExit(Index v, const Vector3& d)
  {
    traversal_.ball(v, ball_);
    for (const Index t : ball_)
    {
      const int corner = mesh_.tet(t).cornerOf(v);
      if (passes(mesh_.tet(t).face(corner), mesh_.point(v), d))
      {
        return halfFace(t, corner);
      }
    }
    return None;
  }
  HalfFace exitFrom(HalfFace entry, const Vector3& from, const Vector3& d) const
  {
    for (int f = 0; f < 4; ++f)
    {
      if (f != faceOf(entry) && passes(mesh_.tet(tetOf(entry)).face(f), from, d))
      {
        return halfFace(tetOf(entry), f);
      }
    }
    return None;
  }
  double distanceTo(HalfFace h, const Vector3& from, const Vector3& d) const
  {
    const auto face = mesh_.tet(tetOf(h)).face(faceOf(h));
    const Vector3& a = mesh_.point(face[0]);
    const Vector3 n = cross(mesh_.point(face[1]) - a, mesh_.point(face[2]) - a);
    const double across = dot(n, d);
    return across != 0 ? std::max(0.0, dot(n, a - from) / across) : std::numeric_limits<double>::infinity();
  }

  const TetMesh& mesh_;
  Traversal traversal_;
  std::vector<Index> ball_;
};

// Columns that may meet a surface: tall ones, and those that look at a boundary face in their own ball.
std::vector<char> findSuspects(const TetMesh& mesh, double gapFraction, const ColumnSet& set)
{
  std::vector<char> suspect(set.columns.size(), 0);
  for (std::size_t i = 0; i < set.columns.size(); ++i)
  {
    const Column& c = set.columns[i];
    suspect[i] = c.levels > 0 && set.thickness(c) * norm(c.direction) > 0.5 * gapFraction * c.size;
  }
  for (std::size_t i = 0; i < mesh.boundarySlots(); ++i)
  {
    const BoundaryFace& face = mesh.boundaryFace(static_cast<Index>(i));
    if (!face.isAlive())
    {
      continue;
    }
    const Index opposite = mesh.tet(tetOf(face.inner)).vertex[faceOf(face.inner)];
    if (const Index c = set.standingAt(opposite); c != None)
    {
      suspect[c] = 1;
    }
  }
  return suspect;
}

// The directions of all columns on each root that may meet a surface.
std::vector<std::vector<Vector3>> raysOf(const ColumnSet& set, const std::vector<char>& suspect)
{
  std::vector<std::vector<Vector3>> rays(set.columns.size());
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    if (suspect[i])
    {
      rays[i].push_back(set.columns[i].direction);
    }
  }
  for (const Fan& fan : set.fans)
  {
    if (suspect[fan.column])
    {
      rays[fan.column].insert(rays[fan.column].end(), fan.directions.begin(), fan.directions.end());
    }
  }
  return rays;
}
} // namespace

int levelBelow(const ColumnSet& set, const Column& column, double height)
{
  const LayerHeights& heights = set.heightsOf(column);
  int level = column.levels;
  while (level > 0 && heights.height(level) > height)
  {
    --level;
  }
  return level;
}

void limitByIsotropicSize(const LayerPlan& plan, ColumnSet& set)
{
  for (Column& c : set.columns)
  {
    const LayerHeights& heights = set.heightsOf(c);
    const double largest = plan[c.patch].isotropicFraction * c.size;
    int level = c.levels;
    while (level > 0 && heights.spacing(level) > largest)
    {
      --level;
    }
    c.limit(level, StopReason::IsotropicSize);
  }
}

void limitByGap(const TetMesh& mesh, const BoundaryStars& stars, double gapFraction, ColumnSet& set)
{
  RayWalk walk(mesh);
  const std::vector<std::vector<Vector3>> rays = raysOf(set, findSuspects(mesh, gapFraction, set));
  for (std::size_t i = 0; i < set.columns.size(); ++i)
  {
    Column& c = set.columns[i];
    // A column in the boundary itself has no inside to look through: see followSides.
    if (c.sides[0] != 0 || !stars.isOnBoundary(c.root))
    {
      continue;
    }
    for (const Vector3& direction : rays[i])
    {
      const double scale = norm(direction);
      const double reach = set.thickness(c) * scale / gapFraction;
      const Vector3 ray = normalized((1 / scale) * direction + RayLean);
      const double free = walk.freeDistance(c.root, ray, reach);
      if (free < reach)
      {
        c.limit(levelBelow(set, c, gapFraction * free / scale), StopReason::Gap);
      }
    }
  }
}

void limitBySlope(const TetMesh& mesh, const BoundaryStars& stars, ColumnSet& set)
{
  // Lowest first, so that each column is settled when its turn comes (as Dijkstra's shortest paths).
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::size_t i = 0; i < set.columns.size(); ++i)
  {
    if (set.columns[i].levels < set.columns[i].asked)
    {
      queue.emplace(set.thickness(set.columns[i]), static_cast<Index>(i));
    }
  }
  while (!queue.empty())
  {
    const auto [height, i] = queue.top();
    queue.pop();
    const Column& c = set.columns[i];
    if (height > set.thickness(c))
    {
      continue;
    }
    for (const Index face : stars.facesAt(c.vertex))
    {
      for (const Index v : mesh.boundaryVertices(face))
      {
        const Index j = set.standingAt(v);
        if (j == None || j == i)
        {
          continue;
        }
        Column& other = set.columns[j];
        const double allowed = height + LargestSlope * distance(c.base, other.base);
        if (set.thickness(other) > allowed)
        {
          other.limit(levelBelow(set, other, allowed), StopReason::Transition);
          queue.emplace(set.thickness(other), j);
        }
      }
    }
  }
}
} // namespace ransmesh

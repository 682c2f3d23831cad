#include "Layers/SideColumns.h"

#include "Layers/ColumnLimits.h"
#include "Layers/SideWalk.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
// A path that stays this close to the straight line, in its own lengths, is straight.
constexpr double Straight = 1e-7;
// Where a side goes on as another patch, columns may come so near, as a share of the way.
constexpr double ShareToContinuation = 0.8;
// Wall faces that see a column's direction worse than this do not count for its height.
constexpr double LeastVisibility = 0.1;

std::vector<char> patchesThatAreSides(const ColumnSet& set, std::size_t patchCount)
{
  std::vector<char> isSide(patchCount, 0);
  for (const Column& c : set.columns)
  {
    for (const int side : c.sides)
    {
      isSide[side] = c.levels > 0 || isSide[side];
    }
  }
  isSide[0] = 0;
  return isSide;
}

// The mean normal of the wall faces, so long that the column's direction rises by one.
Vector3 upOf(const Column& c, const BoundaryStars& stars, const LayerPlan& plan)
{
  const Vector3 d = normalized(c.direction);
  Vector3 up;
  for (const Index face : stars.facesAt(c.vertex))
  {
    const FaceAtVertex seen = stars.seenFrom(c.vertex, face);
    if (plan[seen.patch].hasLayers() && !c.staysIn(seen.patch) && dot(seen.normal, d) > LeastVisibility)
    {
      up += seen.angle * seen.normal;
    }
  }
  const double rise = dot(up, c.direction);
  return rise > 0 ? (1 / rise) * up : (1 / dot(c.direction, c.direction)) * c.direction;
}

bool isStraight(const ColumnSet& set, const Column& c, const SidePath& path)
{
  return std::all_of(path.nodes.begin() + 1, path.nodes.end(),
    [&](const SidePath::Node& node)
    {
      const double h = std::min(node.height, set.thickness(c));
      return distance(path.at(h), c.base + h * c.direction) <= Straight * h * norm(c.direction);
    });
}

class Follower
{
public:
  Follower(const TetMesh& mesh, const BoundaryStars& stars, const LayerPlan& plan, double gapFraction,
    ColumnSet& set)
    : stars_(stars)
    , plan_(plan)
    , gapFraction_(gapFraction)
    , set_(set)
    , normals_(mesh, stars, patchesThatAreSides(set, plan.size()))
    , walk_(mesh, stars, normals_)
  {
  }

  void follow(Column& c)
  {
    const SideStart start{ c.vertex, c.sides, c.direction, upOf(c, stars_, plan_) };
    const SideWay way = walk_.follow(start, set_.thickness(c) / gapFraction_);
    if (way.path.nodes.size() < 2)
    {
      c.limit(0, way.end == WalkEnd::Border ? StopReason::Gap : StopReason::CurvedSide);
      return;
    }
    if (!isStraight(set_, c, way.path))
    {
      const SidePath::Node& first = way.path.nodes[1];
      c.direction = (1 / first.height) * (first.point - c.base);
      c.path = static_cast<Index>(set_.paths.size());
      set_.paths.push_back(way.path);
    }
    limit(c, way);
  }

private:
  void limit(Column& c, const SideWay& way)
  {
    if (way.end == WalkEnd::Border || way.end == WalkEnd::Continued)
    {
      const double share = way.end == WalkEnd::Border ? gapFraction_ : ShareToContinuation;
      c.limit(levelBelow(set_, c, share * way.path.top()), StopReason::Gap);
    }
    else if (way.end != WalkEnd::Reached)
    {
      c.limit(levelBelow(set_, c, way.path.top()), StopReason::CurvedSide);
    }
  }

  const BoundaryStars& stars_;
  const LayerPlan& plan_;
  double gapFraction_;
  ColumnSet& set_;
  SurfaceNormals normals_;
  SideWalk walk_;
};
} // namespace

void followSides(
  const TetMesh& mesh, const BoundaryStars& stars, const LayerPlan& plan, double gapFraction, ColumnSet& set)
{
  Follower follower(mesh, stars, plan, gapFraction, set);
  for (Column& c : set.columns)
  {
    if (c.levels > 0 && c.sides[0] != 0)
    {
      follower.follow(c);
    }
  }
}
} // namespace ransmesh

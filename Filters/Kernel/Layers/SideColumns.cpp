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

// The mean normal of the wall faces below a column's step, so long that the step rises by one.
Vector3 upOf(const Column& c, const Vector3& step, const BoundaryStars& stars, const LayerPlan& plan)
{
  const Vector3 d = normalized(step);
  Vector3 up;
  for (const Index face : stars.facesAt(c.root))
  {
    const FaceAtVertex seen = stars.seenFrom(c.root, face);
    if (plan[seen.patch].hasLayers() && !c.staysIn(seen.patch) && dot(seen.normal, d) > LeastVisibility)
    {
      up += seen.angle * seen.normal;
    }
  }
  const double rise = dot(up, step);
  return rise > 0 ? (1 / rise) * up : (1 / dot(step, step)) * step;
}

// Along the path, does a straight column of this step stay on it?
bool isStraight(const ColumnSet& set, const Column& c, const Vector3& step, const SidePath& path)
{
  return std::all_of(path.nodes.begin() + 1, path.nodes.end(),
    [&](const SidePath::Node& node)
    {
      const double h = std::min(node.height, set.thickness(c));
      return distance(path.at(h), c.base + h * step) <= Straight * h * norm(step);
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
    const SideWay way = walkAlong(c, c.direction);
    limit(c, way);
    if (c.levels > 0)
    {
      c.path = adoptPath(c, way.path, c.direction);
    }
  }

  void follow(Fan& fan)
  {
    Column& c = set_.columns[fan.column];
    std::vector<SideWay> ways;
    for (const Vector3& step : fan.directions)
    {
      ways.push_back(walkAlong(c, step));
    }
    ways.push_back(walkAlong(c, c.direction));
    const bool allGo =
      std::all_of(ways.begin(), ways.end(), [](const SideWay& way) { return way.path.nodes.size() > 1; });
    if (!allGo)
    {
      closeFan(fan);
      return;
    }
    std::for_each(ways.begin(), ways.end(), [&](const SideWay& way) { limit(c, way); });
    for (std::size_t i = 0; i < fan.directions.size(); ++i)
    {
      fan.paths.push_back(adoptPath(c, ways[i].path, fan.directions[i]));
    }
    c.path = adoptPath(c, ways.back().path, c.direction);
  }

  // Drops the fans that the sides do not allow, and the tensor corners, which are straight, of columns that
  // are not.
  void dropWhatIsClosed()
  {
    std::erase_if(set_.fans,
      [this](const Fan& fan)
      { return std::find(isClosed_.begin(), isClosed_.end(), fan.column) != isClosed_.end(); });
    std::erase_if(
      set_.corners, [this](const TensorCorner& corner) { return set_.columns[corner.column].path != None; });
  }

private:
  // Keeps the path, if a straight column of this step would leave it; the step is then the path's first one.
  Index adoptPath(const Column& c, const SidePath& path, Vector3& step)
  {
    if (c.levels == 0 || isStraight(set_, c, step, path))
    {
      return None;
    }
    const SidePath::Node& first = path.nodes[1];
    step = (1 / first.height) * (first.point - c.base);
    set_.paths.push_back(path);
    return static_cast<Index>(set_.paths.size()) - 1;
  }

  // Leaves the column alone on its root.
  void closeFan(const Fan& fan)
  {
    Column& c = set_.columns[fan.column];
    isClosed_.push_back(fan.column);
    c.direction = fan.single;
    if (norm(fan.single) == 0)
    {
      c.limit(0, StopReason::CurvedSide);
      return;
    }
    follow(c);
  }

  SideWay walkAlong(const Column& c, const Vector3& step) const
  {
    const SideStart start{ c.root, c.sides, step, upOf(c, step, stars_, plan_) };
    return walk_.follow(start, set_.thickness(c) / gapFraction_);
  }

  void limit(Column& c, const SideWay& way) const
  {
    if (way.path.nodes.size() < 2)
    {
      c.limit(0, way.end == WalkEnd::Border ? StopReason::Gap : StopReason::CurvedSide);
    }
    else if (way.end == WalkEnd::Border || way.end == WalkEnd::Continued)
    {
      const double share = way.end == WalkEnd::Border ? gapFraction_ : ShareToContinuation;
      limitHeight(set_, c, share * way.path.top(), StopReason::Gap);
    }
    else if (way.end != WalkEnd::Reached)
    {
      limitHeight(set_, c, way.path.top(), StopReason::CurvedSide);
    }
  }

  const BoundaryStars& stars_;
  const LayerPlan& plan_;
  double gapFraction_;
  ColumnSet& set_;
  SurfaceNormals normals_;
  SideWalk walk_;
  std::vector<Index> isClosed_; // columns whose fans are dropped
};
} // namespace

void followSides(
  const TetMesh& mesh, const BoundaryStars& stars, const LayerPlan& plan, double gapFraction, ColumnSet& set)
{
  Follower follower(mesh, stars, plan, gapFraction, set);
  std::vector<char> hasFan(set.columns.size(), 0);
  for (const Fan& fan : set.fans)
  {
    hasFan[fan.column] = 1;
  }
  for (std::size_t i = 0; i < set.columns.size(); ++i)
  {
    Column& c = set.columns[i];
    if (c.levels > 0 && c.sides[0] != 0 && !hasFan[i])
    {
      follower.follow(c);
    }
  }
  for (Fan& fan : set.fans)
  {
    if (const Column& c = set.columns[fan.column]; c.levels > 0 && c.sides[0] != 0)
    {
      follower.follow(fan);
    }
  }
  follower.dropWhatIsClosed();
}
} // namespace ransmesh

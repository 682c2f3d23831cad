#include "Insertion/FrontRaising.h"

#include "Insertion/GroupRaising.h"
#include "Insertion/JointMove.h"
#include "Insertion/StackFolds.h"
#include "Layers/ColumnLimits.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
// A sweep's step: a share of the shortest of the wall's edges at a column, and one of the height, with which the edges
// beyond the front grow. Between needles a step of the mean edge is the whole height at once: tops that cannot go it
// with their neighbours are then left behind for good. Steps of 0.3 mean edges all the way took twice as many moves of
// single tops on an aircraft, from whose narrow trailing edges columns rise by forty edges, and left more tops behind;
// so do longer first steps. With half of that share of the height the raising took a sixth longer there.
constexpr double StepOfSize = 0.3;
constexpr double StepOfHeight = 0.8;
// Sweeps after the last planned one, with growing effort.
constexpr int ExtraSweeps = 6;
// While others still move, a top waits after one failure: most often its neighbours, once they have moved, make room.
// Where four were allowed at once, single tops took twice as many moves on an aircraft, and none came farther.
constexpr int FailuresPerSweep = 1;
constexpr int FailuresPerExtraSweep = 4;
// A top that failed in so many of the planned sweeps waits for the extra ones.
constexpr int PatienceInSweeps = 6;
// No step is tried that is shorter than this share of the first height.
constexpr double ShortestOfFirstHeight = 0.5;
// A step that is all but complete is completed, so that coordinates are exactly the level's.
constexpr double Complete = 0.99999;

constexpr MoveEffort Efforts[4] = { { 0.05, 8 }, { 0.02, 16 }, { 0.01, 30 }, { LeastQualityOfMoves, 60 } };
constexpr int SweepsPerEffort = 2;

class Raiser
{
public:
  Raiser(TetMesh& mesh, ColumnSet& set, const Classification& classes, double maximumSurfaceAngle,
    RaisingReport& report)
    : mesh_(mesh)
    , set_(set)
    , report_(report)
    , front_(mesh, set)
    , turns_(mesh, set, maximumSurfaceAngle)
    , joint_(mesh, set, turns_, front_)
    , moves_(mesh, set, classes, turns_, front_)
    , steps_(set.columns.size(), 0)
    , refusals_(set.columns.size(), 0)
    , nextStep_(set.columns.size(), 1)
    , ofCorner_(set.columns.size(), 0)
  {
    for (const TensorCorner& corner : set.corners)
    {
      ofCorner_[corner.column] = 1;
    }
    for (std::size_t c = 0; c < set.columns.size(); ++c)
    {
      const Column& column = set.columns[c];
      if (column.levels > 0)
      {
        const double way = set.thickness(column) * norm(column.direction);
        steps_[c] = stepsFor(way / front_.shortestEdge(static_cast<Index>(c)));
        nextStep_[c] = 1.0 / steps_[c];
        sweeps_ = std::max(sweeps_, steps_[c]);
      }
    }
  }

  bool run(const Context& context)
  {
    bool done = false;
    for (int sweep = 1; !done && sweep <= sweeps_ + ExtraSweeps; ++sweep)
    {
      if (context.stopped())
      {
        return false;
      }
      context.report(0.2 + 0.5 * sweep / (sweeps_ + ExtraSweeps), "raising the layers' outer front");
      if (sweep <= sweeps_)
      {
        moveTogether(sweep);
      }
      done = moveOneByOne(sweep) == 0 && sweep >= sweeps_;
    }
    GroupRaising groups(mesh_, set_, front_, moves_);
    if (!done && !groups.run(context))
    {
      return false;
    }
    settleStuckTops();
    return true;
  }

private:
  double targetShare(Index c, int sweep) const
  {
    if (sweep >= steps_[c])
    {
      return steps_[c] == 0 ? 0 : 1;
    }
    return height_[sweep] / height_[steps_[c]];
  }

  // The number of steps for a way, which is given in shortest edges of the wall.
  int stepsFor(double way)
  {
    int steps = 1;
    while (heightAfter(steps) < way * (1 - 1e-9))
    {
      ++steps;
    }
    return steps;
  }

  double heightAfter(int steps)
  {
    while (static_cast<int>(height_.size()) <= steps)
    {
      height_.push_back(height_.back() + StepOfSize + StepOfHeight * height_.back());
    }
    return height_[steps];
  }

  // Tops that are behind go by steps of their own: to try the whole way again with the others is in vain.
  void moveTogether(int sweep)
  {
    std::vector<double> target(set_.columns.size());
    for (std::size_t c = 0; c < target.size(); ++c)
    {
      const auto column = static_cast<Index>(c);
      const bool keepsUp = front_.share(column) >= targetShare(column, sweep - 1);
      target[c] = keepsUp ? targetShare(column, sweep) : 0;
    }
    report_.movedTogether += joint_.run(target);
  }

  // Gives the number of tops that are still behind.
  std::size_t moveOneByOne(int sweep)
  {
    const int extra = std::max(0, sweep - sweeps_);
    const int effort = (extra + SweepsPerEffort - 1) / SweepsPerEffort;
    const int mostFailures = extra > 0 ? FailuresPerExtraSweep : FailuresPerSweep;
    std::size_t behind = 0;
    for (std::size_t i = 0; i < set_.columns.size(); ++i)
    {
      const auto c = static_cast<Index>(i);
      const double target = targetShare(c, sweep);
      if (front_.share(c) >= target)
      {
        continue;
      }
      const bool hopeless = refusals_[c] > PatienceInSweeps && sweep <= sweeps_;
      if (!hopeless && !advance(c, target, Efforts[effort], mostFailures))
      {
        ++refusals_[c];
      }
      behind += front_.share(c) < target;
    }
    return behind;
  }

  // Moves the top to the target, or part of the way there. Steps shrink by halves where they fail and grow
  // again where they succeed; the next sweep begins with one that has a chance.
  bool advance(Index c, double target, const MoveEffort& effort, int mostFailures)
  {
    const Column& column = set_.columns[c];
    const double shortest = ShortestOfFirstHeight * set_.heightsOf(column).height(1) / set_.thickness(column);
    bool moved = false;
    int failures = 0;
    while (front_.share(c) < target && failures < mostFailures && nextStep_[c] >= shortest)
    {
      const double wanted = std::min(target, front_.share(c) + nextStep_[c]);
      const double share = wanted > Complete ? 1 : wanted;
      const MoveVerdict verdict = moves_.move(c, front_.position(c, share), effort);
      ++report_.verdicts[static_cast<std::size_t>(verdict)];
      if (isDone(verdict))
      {
        front_.setShare(c, share);
        nextStep_[c] = std::min(1.0, 2 * nextStep_[c]);
        moved = true;
      }
      else
      {
        nextStep_[c] /= 2;
        ++failures;
      }
    }
    nextStep_[c] = std::max(nextStep_[c], shortest);
    return moved;
  }

  void settleStuckTops()
  {
    for (std::size_t i = 0; i < set_.columns.size(); ++i)
    {
      const auto c = static_cast<Index>(i);
      Column& column = set_.columns[i];
      if (column.levels == 0 || front_.share(c) >= 1)
      {
        continue;
      }
      ++report_.stuck;
      settle(c, column);
    }
  }

  // A stuck top that has most of its last spacing makes the column's last level where it is. Any other is
  // lowered onto the highest level below it; where the mesh beyond does not allow that, it stays, and makes
  // the last level, of a spacing of its own. A grid needs its corner's top on a level.
  void settle(Index c, Column& column)
  {
    const int below = levelBelow(set_, column, front_.share(c) * set_.thickness(column));
    if (!ofCorner_[c] && front_.levelsReached(c) > below)
    {
      column.limit(below + 1, StopReason::Refused);
      return;
    }
    if (!lowerTop(mesh_, set_, c, below) && !(ofCorner_[c] && moveOntoLevel(c, below)))
    {
      column.limit(std::max(1, below), StopReason::Refused);
    }
  }

  // Where lowering turns a tetrahedron over, another connectivity may do.
  bool moveOntoLevel(Index c, int level)
  {
    Column& column = set_.columns[c];
    for (; level > 0 && level >= column.lowest; --level)
    {
      if (isDone(moves_.move(c, set_.pointAt(column, level), Efforts[3])))
      {
        column.limit(level, StopReason::Refused);
        return true;
      }
    }
    return false;
  }

  TetMesh& mesh_;
  ColumnSet& set_;
  RaisingReport& report_;
  Front front_;
  SideTurns turns_;
  JointMove joint_;
  FrontMoves moves_;
  std::vector<int> steps_;
  std::vector<int> refusals_;
  std::vector<double> nextStep_;      // shares that a top tries to gain at once
  std::vector<char> ofCorner_;        // by column: does it stand in a tensor corner?
  std::vector<double> height_{ 0.0 }; // after each step, in shortest edges of the wall
  int sweeps_ = 0;
};
} // namespace

bool raiseFront(TetMesh& mesh, ColumnSet& set, const Classification& classes, double maximumSurfaceAngle,
  const Context& context, RaisingReport& report)
{
  Raiser raiser(mesh, set, classes, maximumSurfaceAngle, report);
  return raiser.run(context);
}
} // namespace ransmesh

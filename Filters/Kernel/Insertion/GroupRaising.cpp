#include "Insertion/GroupRaising.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ransmesh
{
namespace
{
// Rings of tops that are taken along: first few, then more.
constexpr int MostRings = 4;
// Larger groups cost more than they bring.
constexpr std::size_t LargestGroup = 400;
// Of all groups that are tried, so that no time is lost where many tops are stuck.
constexpr std::size_t MostColumns = 2000;
// From the lowest top's height to the largest one, each step so many times the one before.
constexpr int Steps = 40;
// From a wall the steps begin at this share of the largest height.
constexpr double LowestStart = 1e-3;
// In each step, and when they are lowered, all are tried so often: one makes room for another.
constexpr int RaisingPasses = 3;
constexpr int LoweringPasses = 4;
// A way that fails is tried by halves.
constexpr int MostFailures = 4;
constexpr MoveEffort Effort{ LeastQualityOfMoves, 60 };
} // namespace

bool GroupRaising::run(const Context& context)
{
  for (int rings = 1; rings <= MostRings; ++rings)
  {
    isGrouped_.assign(set_.columns.size(), 0);
    for (const Index c : stuckColumns())
    {
      if (context.stopped())
      {
        return false;
      }
      if (!isStuck(c) || isGrouped_[c] != 0)
      {
        continue;
      }
      tryTogether(withRings(groupOf(c), rings));
    }
  }
  return true;
}

std::vector<Index> GroupRaising::stuckColumns() const
{
  std::vector<Index> stuck;
  for (std::size_t i = 0; i < set_.columns.size(); ++i)
  {
    if (isStuck(static_cast<Index>(i)))
    {
      stuck.push_back(static_cast<Index>(i));
    }
  }
  return stuck;
}

// The stuck columns that are one's neighbours, their neighbours, and so on.
std::vector<Index> GroupRaising::groupOf(Index column)
{
  std::vector<Index> group{ column };
  for (std::size_t i = 0; i < group.size(); ++i) // they become more
  {
    isGrouped_[group[i]] = 1;
    addAround(group, i, [this](Index c) { return isStuck(c); });
  }
  return group;
}

std::vector<Index> GroupRaising::withRings(std::vector<Index> columns, int rings)
{
  std::size_t next = 0;
  for (int ring = 0; ring < rings; ++ring)
  {
    for (const std::size_t end = columns.size(); next < end; ++next)
    {
      addAround(columns, next, [](Index) { return true; });
    }
  }
  return columns;
}

// Adds the columns whose tops have a tetrahedron in common with that of one of them.
template <class Condition>
void GroupRaising::addAround(std::vector<Index>& columns, std::size_t which, Condition isWanted)
{
  traversal_.ball(set_.columns[columns[which]].vertex, ball_);
  for (const Index t : ball_)
  {
    for (const Index v : mesh_.tet(t).vertex)
    {
      const Index c = set_.standingAt(v);
      if (c != None && isWanted(c) && std::find(columns.begin(), columns.end(), c) == columns.end())
      {
        columns.push_back(c);
      }
    }
  }
}

void GroupRaising::tryTogether(const std::vector<Index>& columns)
{
  if (columns.size() > std::min(LargestGroup, MostColumns - tried_))
  {
    return;
  }
  tried_ += columns.size();
  std::vector<double> before;
  double lowest = std::numeric_limits<double>::infinity();
  for (const Index c : columns)
  {
    before.push_back(front_.share(c));
    lowest = std::min(lowest, heightOf(c));
  }
  const int levelsBefore = levelsReached(columns);
  mesh_.beginTrial();
  lower(columns, lowest);
  raise(columns, lowest);
  if (levelsReached(columns) > levelsBefore)
  {
    mesh_.keepTrial();
    return;
  }
  mesh_.undoTrial();
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    front_.setShare(columns[i], before[i]);
  }
}

void GroupRaising::lower(const std::vector<Index>& columns, double height)
{
  for (int pass = 0; pass < LoweringPasses; ++pass)
  {
    for (const Index c : columns)
    {
      const double share = height / thicknessOf(c);
      double way = front_.share(c) - share;
      for (int failures = 0; way > 0 && failures < MostFailures; ++failures, way /= 2)
      {
        if (moveTo(c, failures == 0 ? share : front_.share(c) - way))
        {
          break;
        }
      }
    }
  }
}

void GroupRaising::raise(const std::vector<Index>& columns, double height)
{
  double highest = 0;
  for (const Index c : columns)
  {
    highest = std::max(highest, thicknessOf(c));
  }
  const double start = std::max(height, LowestStart * highest);
  for (int step = 1; step <= Steps; ++step)
  {
    const double now = start * std::pow(highest / start, static_cast<double>(step) / Steps);
    for (int pass = 0; pass < RaisingPasses; ++pass)
    {
      for (const Index c : columns)
      {
        raiseTowards(c, step == Steps ? 1 : std::min(1.0, now / thicknessOf(c)));
      }
    }
  }
}

void GroupRaising::raiseTowards(Index column, double share)
{
  double step = 1;
  for (int failures = 0; front_.share(column) < share && failures < MostFailures;)
  {
    const double wanted = std::min(share, front_.share(column) + step);
    if (wanted <= front_.share(column)) // the step is lost in rounding
    {
      return;
    }
    if (!moveTo(column, wanted))
    {
      step = (wanted - front_.share(column)) / 2;
      ++failures;
    }
  }
}

bool GroupRaising::moveTo(Index column, double share)
{
  if (!isDone(moves_.move(column, front_.position(column, share), Effort)))
  {
    return false;
  }
  front_.setShare(column, share);
  return true;
}

int GroupRaising::levelsReached(const std::vector<Index>& columns) const
{
  int levels = 0;
  for (const Index c : columns)
  {
    levels += front_.levelsReached(c);
  }
  return levels;
}
} // namespace ransmesh

#include "Removal/PoorMending.h"

#include <algorithm>
#include <iterator>

namespace ransmesh
{
void PoorMending::note(std::span<const Index> made, double poor)
{
  noteChange(made);
  if (!(poor > 0))
  {
    return;
  }
  std::copy_if(
    made.begin(), made.end(), std::back_inserter(poor_), [&](Index t) { return qualityOf(mesh_, t) < poor; });
}

void PoorMending::begin()
{
  improvement_.noteChanges();
}

bool PoorMending::move(Index v, double keep)
{
  return noteMove(improvement_.move(v, keep));
}

bool PoorMending::moveTowards(Index v, const Vector3& place, double floor)
{
  return noteMove(improvement_.moveTowards(v, place, floor));
}

bool PoorMending::noteMove(bool moved)
{
  if (moved)
  {
    noteChange(improvement_.around());
  }
  return moved;
}

std::size_t PoorMending::swapAround(Index v, double poor)
{
  std::size_t swaps = 0;
  traversal_.ball(v, ball_);
  for (const Index t : ball_)
  {
    if (mesh_.tet(t).isAlive() && mesh_.tet(t).has(v) && qualityOf(mesh_, t) < poor && swap(t))
    {
      ++swaps;
      note(improvement_.made(), poor);
    }
  }
  return swaps;
}

std::size_t PoorMending::mendAll(double poor)
{
  constexpr int rounds = 3;
  std::size_t swaps = 0;
  std::sort(poor_.begin(), poor_.end());
  poor_.erase(std::unique(poor_.begin(), poor_.end()), poor_.end());
  for (int round = 0; round < rounds && !poor_.empty(); ++round)
  {
    std::vector<Index> next;
    for (const Index t : poor_)
    {
      if (mesh_.tet(t).isAlive() && qualityOf(mesh_, t) < poor && swap(t))
      {
        ++swaps;
        noteChange(improvement_.made());
        next.insert(next.end(), improvement_.made().begin(), improvement_.made().end());
      }
    }
    poor_.swap(next);
  }
  return swaps;
}

// Poor tetrahedra stand around common edges: one that was tried in vain, from whichever of them, is tried again only
// when a tetrahedron around it has changed.
bool PoorMending::swap(Index tet)
{
  if (changedAt_.size() < mesh_.tetSlots())
  {
    changedAt_.resize(mesh_.tetSlots(), now_);
  }
  SwapMemory memory;
  memory.changedAt = &changedAt_;
  memory.now = now_;
  return improvement_.swap(tet, memory);
}

void PoorMending::noteChange(std::span<const Index> tets)
{
  if (changedAt_.empty())
  {
    return;
  }
  changedAt_.resize(std::max(changedAt_.size(), mesh_.tetSlots()), now_);
  ++now_;
  for (const Index t : tets)
  {
    changedAt_[t] = now_;
  }
}
} // namespace ransmesh

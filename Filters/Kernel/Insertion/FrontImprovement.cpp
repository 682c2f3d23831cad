#include "Insertion/FrontImprovement.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>

namespace ransmesh
{
namespace
{
constexpr double Poor = 0.15; // angleQuality that is worth a try
constexpr int Passes = 4;
constexpr int PassesWithMoves = 3; // after the last swaps they mend little
// So many swaps may follow from one.
constexpr int LongestChain = 30;
// Of a hundred edges with more tetrahedra around them, three could be swapped away, at twice the cost of others.
constexpr std::size_t LargestRing = 6;
// A move may not make the worst quality at its point worse than this part of what it was.
constexpr double Kept = 1.02;

std::vector<Index> poorTetsAtTops(const TetMesh& mesh, const ColumnSet& set, LocalImprovement& improvement)
{
  std::vector<char> isTop(mesh.vertexCount(), 0); // small, so that it stays in the cache
  for (const Column& c : set.columns)
  {
    isTop[c.vertex] = c.levels > 0;
  }
  std::vector<Index> poor;
  for (std::size_t i = 0; i < mesh.tetSlots(); ++i)
  {
    const auto t = static_cast<Index>(i);
    const Tetrahedron& tet = mesh.tet(t);
    if (tet.isAlive() &&
      std::any_of(tet.vertex.begin(), tet.vertex.end(), [&isTop](Index v) { return isTop[v] != 0; }) &&
      improvement.shapeOf(t, Poor) < Poor)
    {
      poor.push_back(t);
    }
  }
  return poor;
}

// When something changed at which vertex: what failed is tried again only where there is a reason. Without
// that, what cannot become better, as is much at fans and in narrow places, cost nine tenths of this stage.
class Changes
{
public:
  explicit Changes(const TetMesh& mesh)
    : mesh_(mesh)
    , last_(mesh.vertexCount(), 1)
    , ofTet_(mesh.tetSlots(), 1)
    , unmoved_(mesh.vertexCount(), Never)
  {
  }

  static constexpr std::uint32_t Never = 0;

  std::uint32_t count() const { return count_; }
  std::size_t made() const { return count_ - 1; }
  // What a swap has to know that failed at that count of changes. It can succeed only if something changed at every
  // vertex of its edge or face, as all tetrahedra concerned have these, and then only if one of them changed.
  SwapMemory since(Index tet, std::uint32_t triedAt) const
  {
    unsigned corners = 0;
    for (unsigned i = 0; i < 4; ++i)
    {
      corners |= anyAtVertex(mesh_.tet(tet).vertex[i], triedAt) ? 1U << i : 0;
    }
    return { corners, &ofTet_, triedAt, count_ };
  }
  bool isWorthMoving(Index v) const { return anyAtVertex(v, unmoved_[v]); }
  void noteUnmoved(Index v) { unmoved_[v] = count_; }
  void noteMade(const std::vector<Index>& tets)
  {
    ++count_;
    note(tets);
  }

private:
  bool anyAtVertex(Index v, std::uint32_t triedAt) const { return last_[v] > triedAt; }
  void note(const std::vector<Index>& tets)
  {
    ofTet_.resize(std::max(ofTet_.size(), mesh_.tetSlots()), count_);
    for (const Index t : tets)
    {
      ofTet_[t] = count_;
      for (const Index v : mesh_.tet(t).vertex)
      {
        last_[v] = count_;
      }
    }
  }

  const TetMesh& mesh_;
  std::vector<std::uint32_t> last_;    // by vertex
  std::vector<std::uint32_t> ofTet_;   // the same by tetrahedron
  std::vector<std::uint32_t> unmoved_; // by vertex: when it could not be moved
  std::uint32_t count_ = 1;            // so that everything has changed since Never
};

bool isPoor(const TetMesh& mesh, Index tet, LocalImprovement& improvement)
{
  return mesh.tet(tet).isAlive() && improvement.shapeOf(tet, Poor) < Poor;
}

struct Candidate
{
  Index tet;
  std::uint32_t triedAt; // the count of changes when it was tried in vain, or Never
  Index place = None;    // its least vertex
};

// Tetrahedra with a common vertex after each other: what one looks at is in the cache for the next. Numbers of
// tetrahedra made by swaps follow no place; measured on an aircraft, this stage took half as long again by them.
void sortByPlace(const TetMesh& mesh, std::vector<Candidate>& work)
{
  for (Candidate& c : work)
  {
    const auto& v = mesh.tet(c.tet).vertex;
    c.place = *std::min_element(v.begin(), v.end());
  }
  std::sort(work.begin(), work.end(),
    [](const Candidate& a, const Candidate& b)
    { return std::tie(a.place, a.tet) < std::tie(b.place, b.tet); });
}

// Swaps a candidate away if that can be, and what is poor of that which comes instead, while it is in the cache. What
// stays poor is added to left.
void swapAway(const Candidate& first, const TetMesh& mesh, LocalImprovement& improvement, Changes& changes,
  std::vector<Candidate>& left)
{
  std::vector<Candidate> work(1, first);
  int made = 0;
  while (!work.empty())
  {
    const Index t = work.back().tet;
    const std::uint32_t triedAt = work.back().triedAt;
    work.pop_back();
    if (!isPoor(mesh, t, improvement))
    {
      continue;
    }
    const SwapMemory memory = changes.since(t, triedAt);
    if (memory.corners == 0 || made == LongestChain)
    {
      left.push_back({ t, triedAt });
      continue;
    }
    if (!improvement.swap(t, memory))
    {
      left.push_back({ t, changes.count() });
      continue;
    }
    ++made;
    changes.noteMade(improvement.made());
    for (const Index tet : improvement.made())
    {
      work.push_back({ tet, Changes::Never });
    }
  }
}

// Swaps away what can be; gives the poor tetrahedra that are there after it.
std::vector<Candidate> swapAway(
  const std::vector<Candidate>& work, const TetMesh& mesh, LocalImprovement& improvement, Changes& changes)
{
  std::vector<Candidate> left;
  for (const Candidate& candidate : work)
  {
    swapAway(candidate, mesh, improvement, changes, left);
  }
  std::erase_if(left, [&](const Candidate& c) { return !isPoor(mesh, c.tet, improvement); });
  return left;
}

// Moves the corners of the tetrahedra where there is a reason to try.
void moveCorners(
  const std::vector<Candidate>& work, const TetMesh& mesh, LocalImprovement& improvement, Changes& changes)
{
  for (const Candidate& c : work)
  {
    for (const Index v : mesh.tet(c.tet).vertex)
    {
      if (!changes.isWorthMoving(v))
      {
        continue;
      }
      if (improvement.move(v, Kept))
      {
        changes.noteMade(improvement.around());
      }
      else
      {
        changes.noteUnmoved(v);
      }
    }
  }
}
} // namespace

std::size_t improveBeyondFront(
  TetMesh& mesh, const ColumnSet& set, const BoundaryRules& rules, const Context& context)
{
  LocalImprovement improvement(mesh, rules, angleQuality, LargestRing);
  Changes changes(mesh);
  std::vector<Candidate> work;
  for (const Index t : poorTetsAtTops(mesh, set, improvement))
  {
    work.push_back({ t, Changes::Never });
  }
  for (int pass = 0; pass < Passes && !work.empty() && !context.stopped(); ++pass)
  {
    sortByPlace(mesh, work);
    // All swaps before all moves: each swap is a reason to try to move all vertices around again.
    work = swapAway(work, mesh, improvement, changes);
    if (pass < PassesWithMoves)
    {
      moveCorners(work, mesh, improvement, changes);
    }
  }
  return changes.made();
}
} // namespace ransmesh

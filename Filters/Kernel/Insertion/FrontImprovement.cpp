#include "Insertion/FrontImprovement.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
constexpr double Poor = 0.15; // angleQuality that is worth a try
// Above this quality no angle is so large; it spares computing the angles of most.
constexpr double Suspect = 0.4;
constexpr int Passes = 5;
// A move may not make the worst quality at its point worse than this part of what it was.
constexpr double Kept = 1.02;

std::vector<Index> poorTetsAtTops(
  const TetMesh& mesh, const ColumnSet& set, const LocalImprovement& improvement)
{
  std::vector<Index> poor;
  for (std::size_t i = 0; i < mesh.tetSlots(); ++i)
  {
    const auto t = static_cast<Index>(i);
    const Tetrahedron& tet = mesh.tet(t);
    const auto isTop = [&set](Index v) { return set.standingAt(v) != None; };
    if (tet.isAlive() && std::any_of(tet.vertex.begin(), tet.vertex.end(), isTop) &&
      qualityOf(mesh, t) < Suspect && improvement.shapeOf(t) < Poor)
    {
      poor.push_back(t);
    }
  }
  return poor;
}
} // namespace

std::size_t improveBeyondFront(
  TetMesh& mesh, const ColumnSet& set, const BoundaryRules& rules, const Context& context)
{
  LocalImprovement improvement(mesh, rules, angleQuality);
  std::vector<Index> work = poorTetsAtTops(mesh, set, improvement);
  std::size_t changes = 0;
  for (int pass = 0; pass < Passes && !work.empty() && !context.stopped(); ++pass)
  {
    std::vector<Index> next;
    for (const Index t : work)
    {
      if (!mesh.tet(t).isAlive() || !(improvement.shapeOf(t) < Poor))
      {
        continue;
      }
      if (improvement.swap(t))
      {
        ++changes;
        next.insert(next.end(), improvement.made().begin(), improvement.made().end());
        continue;
      }
      const auto corners = mesh.tet(t).vertex;
      const auto moved = std::count_if(
        corners.begin(), corners.end(), [&improvement](Index v) { return improvement.move(v, Kept); });
      changes += static_cast<std::size_t>(moved);
      next.push_back(t);
    }
    work.swap(next);
  }
  return changes;
}
} // namespace ransmesh

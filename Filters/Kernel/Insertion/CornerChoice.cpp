#include "Insertion/CornerChoice.h"

#include <algorithm>
#include <map>

namespace ransmesh
{
namespace
{
int cornerOf(const BaseFace& face, Index vertex)
{
  return face.vertex[0] == vertex ? 0 : face.vertex[1] == vertex ? 1 : 2;
}

// Every column of a grid ends with its corner's. Where that was to be cut short, the grid would make many short
// columns of one.
bool isCutShort(const Column& c)
{
  return c.levels < c.asked && c.reason != StopReason::Refused;
}

// Beside those of the corner's own column.
std::size_t pointsInGrid(int levels, int walls)
{
  const auto size = static_cast<std::size_t>(levels) + 1;
  return (walls == 3 ? size * size * size : size * size) - size;
}
} // namespace

Vector3 normalOf(const std::array<Vector3, 3>& triangle)
{
  return normalized(cross(triangle[1] - triangle[0], triangle[2] - triangle[0]));
}

CornerChoice::CornerChoice(const TetMesh& mesh, const ColumnSet& set, const std::vector<BaseFace>& faces)
  : mesh_(mesh)
  , set_(set)
  , faces_(faces)
  , ofColumn_(set.columns.size(), None)
  , states_(set.corners.size())
{
  for (std::size_t i = 0; i < set.corners.size(); ++i)
  {
    const Column& c = set.columns[set.corners[i].column];
    ofColumn_[set.corners[i].column] = static_cast<Index>(i);
    // A stuck top is not where the grid would have it.
    const bool isStuck = c.levels > 0 && mesh.point(c.vertex) != set.pointAt(c, c.levels);
    const bool isPlanned = c.levels > 0 && !isCutShort(c);
    states_[i].active = isPlanned && !isStuck;
    report_.planned += isPlanned;
    report_.lostPoints += isPlanned && isStuck ? pointsInGrid(c.levels, set.corners[i].walls) : 0;
  }
  findEdges();
}

std::size_t CornerChoice::count() const
{
  return static_cast<std::size_t>(
    std::count_if(states_.begin(), states_.end(), [](const CornerState& s) { return s.active; }));
}

void CornerChoice::settle()
{
  for (bool changed = true; changed;)
  {
    changed = false;
    countRidges(changed);
    for (std::size_t i = 0; i < states_.size(); ++i)
    {
      const int wanted = ridgesWanted(static_cast<Index>(i));
      if (states_[i].active && states_[i].ridges != wanted)
      {
        states_[i].active = false;
        changed = true;
      }
    }
  }
}

bool CornerChoice::isRidge(Index face, int j) const
{
  const Index e = edgeOf_[3 * static_cast<std::size_t>(face) + static_cast<std::size_t>(j)];
  return e != None && (isRidgeAt(edges_[e], edges_[e].low) || isRidgeAt(edges_[e], edges_[e].high));
}

void CornerChoice::findEdges()
{
  edgeOf_.assign(3 * faces_.size(), None);
  std::map<std::pair<Index, Index>, Index> known;
  for (std::size_t i = 0; i < faces_.size(); ++i)
  {
    const BaseFace& face = faces_[i];
    if (at(face, 0) == None && at(face, 1) == None && at(face, 2) == None)
    {
      continue;
    }
    for (int j = 0; j < 3; ++j)
    {
      const auto [low, high] = std::minmax(face.vertex[(j + 1) % 3], face.vertex[(j + 2) % 3]);
      const auto [found, isNew] = known.try_emplace({ low, high }, static_cast<Index>(edges_.size()));
      if (isNew)
      {
        edges_.push_back({ low, high });
      }
      FrontEdge& edge = edges_[found->second];
      edge.face[edge.face[0] == None ? 0 : 1] = static_cast<Index>(i);
      edgeOf_[3 * i + static_cast<std::size_t>(j)] = found->second;
    }
  }
}

// Do the edge's faces belong to two walls of the corner at this end?
bool CornerChoice::isRidgeAt(const FrontEdge& edge, Index end) const
{
  if (edge.face[1] == None)
  {
    return false;
  }
  const BaseFace& a = faces_[edge.face[0]];
  const BaseFace& b = faces_[edge.face[1]];
  const Index corner = at(a, cornerOf(a, end));
  return corner != None && wallAt(corner, a) != wallAt(corner, b);
}

void CornerChoice::countRidges(bool& changed)
{
  for (CornerState& state : states_)
  {
    state.ridges = 0;
  }
  for (const FrontEdge& edge : edges_)
  {
    const BaseFace& face = faces_[edge.face[0]];
    const std::array<Index, 2> corners{ at(face, cornerOf(face, edge.low)),
      at(face, cornerOf(face, edge.high)) };
    const std::array<bool, 2> isRidge{ isRidgeAt(edge, edge.low), isRidgeAt(edge, edge.high) };
    // Fans, and ends that see the edge differently.
    const bool odd =
      !face.hasBase() || (corners[0] != None && corners[1] != None && isRidge[0] != isRidge[1]);
    for (int end = 0; end < 2; ++end)
    {
      if (corners[end] != None)
      {
        states_[corners[end]].ridges += isRidge[end] ? 1 : 0;
        changed = changed || odd;
        states_[corners[end]].active = !odd;
      }
    }
  }
}

// A ridge goes on, or ends at a side; three meet where three walls do.
int CornerChoice::ridgesWanted(Index corner) const
{
  const Column& c = set_.columns[set_.corners[corner].column];
  return set_.corners[corner].walls == 3 ? 3 : c.sides[0] != 0 ? 1 : 2;
}
} // namespace ransmesh

// The tetrahedra of the layers, written in closed form.
//
// Between the wall and the front every base face carries a stack. Its corners rise one at a time, level
// by level, in the order of their columns' numbers: when a corner rises from x to x', the tetrahedron
// (the current three corners, x') comes into being, and x' takes x's place. The order is the same in
// every face, so neighbouring stacks match without being looked at; columns of any heights, also none,
// fit. Every tetrahedron has one edge on a column, so that none of its angles exceeds the larger of a
// right angle and the wall triangle's, but for the lean of the columns.
#pragma once

#include "Insertion/BaseFaces.h"
#include "Layers/Column.h"
#include "Mesh/MeshData.h"

#include <algorithm>
#include <vector>

namespace ransmesh
{
// The numbers of the columns' points in the final mesh.
class ColumnPoints
{
public:
  // Level 0 is the root's number; levels 1.. of each column follow each other from firstNew on, but a top
  // that the column owns has the number of its vertex.
  ColumnPoints(const ColumnSet& set, const std::vector<Index>& baseNumber, std::size_t firstNew);
  Index at(Index column, int level) const
  {
    return level == 0 ? base_[column] : level == levels_[column] ? top_[column] : first_[column] + level - 1;
  }
  // How many points are new.
  std::size_t count() const { return count_; }

private:
  std::vector<Index> base_;
  std::vector<Index> first_;
  std::vector<Index> top_;
  std::vector<int> levels_;
  std::size_t count_ = 0;
};

// How the corners of one stack rise.
struct Stack
{
  std::array<Index, 3> root{}; // what each stands on; in a fan corners share one
  std::array<int, 3> levels{};
  std::array<int, 3> rise{ 0, 1, 2 };      // the order within each level
  std::array<int, 3> firstRise{ 0, 1, 2 }; // but the first one
};

Stack stackOf(const ColumnSet& set, const BaseFace& face);

// The number of tetrahedra in a stack.
std::size_t countTets(const Stack& stack);

// Visits the rising corners of a stack in order: visit(level, corner, isFlat), level from 0 below each rise.
// A flat rise, at the bottom of a fan, makes no tetrahedron.
template <class Visit>
void forEachRise(const Stack& stack, Visit visit)
{
  const int highest = std::max({ stack.levels[0], stack.levels[1], stack.levels[2] });
  BaseCorners corners(stack.root);
  for (int level = 0; level < highest; ++level)
  {
    for (const int corner : level == 0 ? stack.firstRise : stack.rise)
    {
      if (level < stack.levels[corner])
      {
        visit(level, corner, corners.isFlat());
        corners.rise(corner);
      }
    }
  }
}

// Where stacks are written to, behind what is there.
struct StackSink
{
  std::vector<std::array<Index, 4>>& tetrahedra;
  std::vector<int>& layer;                          // of each tetrahedron, 1 at the wall
  std::vector<Index>& stacks;                       // the first tetrahedron of each stack
  std::vector<std::array<Index, 3>>& sideTriangles; // new boundary triangles in the side patches, outward
  std::vector<int>& sidePatch;
};

class StackWriter
{
public:
  explicit StackWriter(StackSink& sink)
    : sink_(sink)
  {
  }

  // Writes a stack whose corners' points at each level are pointAt(corner, level); sideOpposite names the side
  // patch beyond the edge opposite to each corner, or 0.
  template <class PointAt>
  void write(const Stack& stack, const std::array<int, 3>& sideOpposite, PointAt pointAt);

private:
  void writeSides(
    const std::array<int, 3>& sideOpposite, const std::array<Index, 3>& current, int corner, Index risen);

  StackSink& sink_;
};

template <class PointAt>
void StackWriter::write(const Stack& stack, const std::array<int, 3>& sideOpposite, PointAt pointAt)
{
  const bool hasSides = sideOpposite != std::array{ 0, 0, 0 };
  std::array<Index, 3> current{ pointAt(0, 0), pointAt(1, 0), pointAt(2, 0) };
  // Room for the whole stack at once: asking for it at each tetrahedron took a third of the writing.
  std::size_t next = sink_.tetrahedra.size();
  const std::size_t end = next + countTets(stack);
  sink_.tetrahedra.resize(end);
  sink_.layer.resize(end);
  if (end > next)
  {
    sink_.stacks.push_back(static_cast<Index>(next));
  }
  forEachRise(stack,
    [&](int below, int corner, bool isFlat)
    {
      const Index risen = pointAt(corner, below + 1);
      if (!isFlat)
      {
        sink_.tetrahedra[next] = { current[0], current[1], current[2], risen };
        sink_.layer[next++] = below + 1;
        if (hasSides)
        {
          writeSides(sideOpposite, current, corner, risen);
        }
      }
      current[corner] = risen;
    });
}
} // namespace ransmesh

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

// Visits the rising corners of a stack in order: visit(level, corner, isFlat), level from 0 below each rise.
// A flat rise, at the bottom of a fan, makes no tetrahedron.
template <class Visit>
void forEachRise(const ColumnSet& set, const BaseFace& face, Visit visit)
{
  int highest = 0;
  std::array<int, 3> levels{};
  for (int j = 0; j < 3; ++j)
  {
    levels[j] = face.column[j] == None ? 0 : set.columns[face.column[j]].levels;
    highest = levels[j] > highest ? levels[j] : highest;
  }
  BaseCorners corners(face);
  for (int level = 0; level < highest; ++level)
  {
    for (const int corner : face.rise)
    {
      if (level < levels[corner])
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
  std::vector<Index>& prism;                        // of each tetrahedron: those of one prism share a number
  std::vector<std::array<Index, 3>>& sideTriangles; // new boundary triangles in the side patches, outward
  std::vector<int>& sidePatch;
};

// The number of tetrahedra in all stacks.
std::size_t countStackTets(const ColumnSet& set, const std::vector<BaseFace>& faces);

// Writes all stacks; whether they fold is asked before (StackFolds.h).
void writeStacks(const ColumnSet& set, const std::vector<BaseFace>& faces, const ColumnPoints& numbers,
  const std::vector<Index>& baseNumber, StackSink& sink);
} // namespace ransmesh

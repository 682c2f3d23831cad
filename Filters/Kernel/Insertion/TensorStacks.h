// Tensor-product grids between walls that meet at concave ridges, as stacks on the walls' triangles.
//
// Each ridge vertex has a grid of points, so many levels above either wall. The plane that halves it, from
// the ridge to the grid's corner, which is the top of the vertex's own column, parts it between the walls:
// above a base point j levels from the ridge stands a column of j levels. So the walls' triangles move
// back from the ridge by the thickness of the layers, strips of new triangles come in between, and stacks
// on all of them, written by the same rule as elsewhere, fill the grid; the front does not notice. Where three walls
// meet, each of them gets a square of base points, and columns end at the nearer of the two planes.
#pragma once

#include "Insertion/BaseFaces.h"
#include "Insertion/CornerChoice.h"
#include "Insertion/LayerStacks.h"

#include <deque>
#include <vector>

namespace ransmesh
{
struct TensorStack
{
  Stack stack;
  std::array<const std::vector<Index>*, 3> chain; // the points above each corner, from the wall up
  std::array<int, 3> sideOpposite{};
  int patch = 0;

  Index at(int corner, int level) const { return (*chain[corner])[level]; }
};

// A new point of the grids.
struct GridPoint
{
  Index column; // the corner's
  int layers;   // levels of the column on it, where it lies on a wall; else None
  int patch;
};

struct TensorStacks
{
  std::vector<TensorStack> stacks;
  std::vector<char> replaced;    // by number of base face: its stack is among these
  std::vector<Vector3> points;   // of the grids, to follow those that are there
  std::vector<GridPoint> origin; // of each of these points
  GridReport report;
  std::deque<std::vector<Index>> chains;
};

// Makes the grids of all tensor corners whose columns stand at their full height and whose stacks do not fold
// nor turn a wall's surface by more than the angle (degrees). points are those of the mesh so far.
TensorStacks makeTensorStacks(const TetMesh& mesh, const ColumnSet& set, const std::vector<BaseFace>& faces,
  const ColumnPoints& numbers, const std::vector<Index>& baseNumber, const std::vector<Vector3>& points,
  double maximumSurfaceAngle);
} // namespace ransmesh

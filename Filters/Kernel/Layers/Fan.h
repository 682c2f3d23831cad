// Fans: several columns at one point of the wall, where convex edges turn it too much for one normal.
//
// Loehner's paper, section 5. The faces around the point fall into groups between its convex edges. Each
// group has a column; between two groups stand more, so that neighbours enclose no more than the fan
// angle.
#pragma once

#include "Geometry/Vector3.h"
#include "Mesh/MeshData.h"

#include <array>
#include <vector>

namespace ransmesh
{
// A step of the walk around the point: a column, and how many of the wall's faces it lifts.
struct FanStep
{
  int column = 0; // number in Fan::directions; their count names the main column
  int faces = 0;
};

struct Fan
{
  Index column = None; // the main column: the root's own, which is split off last
  // Does the main column stand amid the others (three groups and more), or does it end their row?
  bool aroundMain = false;
  bool closed = false;             // does the walk come back to its first face, or run between sides?
  std::array<Index, 2> anchor{};   // the first face's other corners
  std::vector<FanStep> walk;       // around the point, counterclockwise seen from the fluid
  std::vector<Vector3> directions; // of the columns beside the main one; steps that rise by one
  std::vector<Index> paths;        // of these columns in curved sides, None for a straight one; may be empty
  Vector3 single;                  // the main column's direction if the fan can not be opened
};
} // namespace ransmesh

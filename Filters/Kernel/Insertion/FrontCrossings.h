// Where the front would get in its own way.
//
// Columns are limited by the gap to the opposite wall before they rise, but single points do not see everything: a
// front may still run into another one, or into a wall. No connectivity helps there.
#pragma once

#include "Layers/Column.h"
#include "Mesh/TetMesh.h"

#include <array>
#include <map>
#include <vector>

namespace ransmesh
{
class FrontCrossings
{
public:
  // Of the tops of these columns, which do not reach their last levels. Holds until the mesh changes.
  FrontCrossings(const TetMesh& mesh, const ColumnSet& set, const std::vector<Index>& columns);

  // Would the boundary's triangles at the top of the column, one of those given, pass through others, with the top at x,
  // which is not above the column's last level, and all others where they are? Triangles that only touch, or that have
  // a root in common, do not count.
  bool wouldCross(Index column, const Vector3& x) const;

private:
  using Triangle = std::array<Index, 3>;
  struct Surroundings
  {
    std::vector<Triangle> own;
    std::vector<Triangle> near;
  };

  bool haveCommonRoot(const Triangle& a, const Triangle& b) const;

  const TetMesh& mesh_;
  const ColumnSet& set_;
  std::map<Index, Surroundings> around_; // by column
};
} // namespace ransmesh

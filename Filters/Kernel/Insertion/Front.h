// The front: the tops of all columns, which carry a copy of the wall's triangles into the volume.
//
// While the front rises, the mesh holds only what lies beyond it: the wall's vertices themselves move
// out along their columns, and the wall's boundary faces move with them. The slab between the wall and
// the front is known in closed form (LayerStacks.h) and is not part of the mesh yet.
#pragma once

#include "Boundary/Classification.h"
#include "Insertion/BaseFaces.h"
#include "Layers/Column.h"
#include "Mesh/TetMesh.h"

#include <span>
#include <vector>

namespace ransmesh
{
class Front
{
public:
  Front(const TetMesh& mesh, const ColumnSet& set);

  // The share of its height that a column's top has reached, 0 to 1.
  double share(Index column) const { return share_[column]; }
  void setShare(Index column, double share) { share_[column] = share; }
  // Where a column's top stands at that share of its height. At 1 these are exactly the coordinates
  // of the column's last level.
  Vector3 position(Index column, double share) const;
  // How many of its levels the column has if its top stays where it is. A top that has most of its last spacing makes
  // the last level where it stands.
  int levelsReached(Index column) const;
  // Would the slab below the column's faces be positive, with its top at x and all others where they are?
  bool slabAllows(Index column, const Vector3& x) const;
  // The same for one of the faces, by number, all tops where they are.
  bool slabIsPositive(std::size_t face) const;
  const std::vector<BaseFace>& faces() const { return faces_; }
  // The numbers in faces() of those at a column.
  std::span<const Index> facesAt(Index column) const
  {
    return { facesAt_.data() + start_[column], facesAt_.data() + start_[column + 1] };
  }
  // Of the wall's edges at the column's foot in its faces; the column's size where there are none.
  double shortestEdge(Index column) const;

private:
  bool slabIsPositive(std::size_t number, Index moved, const Vector3& x) const;

  const TetMesh& mesh_;
  const ColumnSet& set_;
  std::vector<double> share_;
  std::vector<BaseFace> faces_;
  std::vector<std::array<Vector3, 3>> base_; // of each face: where its corners stand on the wall
  std::vector<std::size_t> start_;           // of each column in facesAt_
  std::vector<Index> facesAt_;
};
} // namespace ransmesh

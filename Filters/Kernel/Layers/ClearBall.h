// How much room a column has beside other walls.
#pragma once

#include "Boundary/BoundaryStars.h"
#include "Layers/Column.h"
#include "Layers/RayWalk.h"
#include "Layers/WayOverWalls.h"
#include "Triangles/TriangleTree.h"

#include <optional>
#include <vector>

namespace ransmesh
{
// Finds the largest balls in the fluid that touch the wall at a column's root: where the layers of two walls grow
// alike, they meet at the centres of these balls (the medial axis; shrinking balls as by Ma, Bae and Choi, 3D medial
// axis point approximation using nearest neighbors and the normal field, The Visual Computer 28 (2012) 7-19). Between
// parallel walls the diameter is the gap; where a wall ends beside the column, so that rays from it pass, it is the gap
// as the layers of both will find it.
class ClearBall
{
public:
  // Layers come on the faces whose vertices all have columns.
  ClearBall(const TetMesh& mesh, const BoundaryStars& stars, const ColumnSet& set);

  // The diameter of the ball that touches the wall at the root, with its centre in the unit direction from there, and
  // another wall; `widest` if there is none in its way. A wall is another one where no way over the walls leads from
  // the root to the place touched that stays within twice the distance between them: in corners of more than 29
  // degrees it leads there.
  double diameter(Index root, const Vector3& direction, double widest);
  // The boundary face that the last ball touches, or None, and where.
  Index faceTouched() const { return faceTouched_; }
  const Vector3& placeTouched() const { return placeTouched_; }

private:
  // A wall's triangle and its plane; the normal is unit, into the fluid.
  struct Wall
  {
    Vector3 normal;
    Vector3 origin;
    std::array<Index, 3> vertex;
    Index face; // the boundary face
  };

  void collectWalls();
  void setDiameter(double diameter);
  bool reaches(const Wall& wall) const;
  void shrink(const Wall& wall);
  bool isOther(Index face, const Vector3& way);

  const TetMesh& mesh_;
  const BoundaryStars& stars_;
  const ColumnSet& set_;
  SurfaceMesh surface_;
  std::optional<TriangleTree> tree_; // of the surface; made when the first ball is asked for
  std::vector<Wall> walls_;          // in the tree's order
  RayWalk walk_;
  WayOverWalls way_;
  Index root_ = None;
  Vector3 from_; // the root
  Vector3 direction_;
  double diameter_ = 0;
  Ball ball_;
  Index faceTouched_ = None;
  Vector3 placeTouched_;
};
} // namespace ransmesh

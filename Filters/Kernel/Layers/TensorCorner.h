// Corners where viscous walls meet at concave ridges: between them the layers of both make a
// tensor-product grid (Loehner's paper, figures 2 and 3).
//
// Two walls at a point of a ridge, or three where three ridges meet. A point of the grid stands so many
// levels above each wall; the column to the corner of the grid, so many above all, is the only one that
// takes part in the raising of the front.
#pragma once

#include "Layers/FaceRing.h"
#include "Mesh/MeshData.h"

#include <array>
#include <vector>

namespace ransmesh
{
// Walls that turn so much into each other (degrees) have a grid: the fluid's angle is 109.5 to 40. The columns of
// a grid are parallel to its other wall; in wider corners they would lean by more than 20 degrees, and there are
// twice as many of them as there are layers: the single column that halves the angle is better. In narrower ones
// such columns would meet those beside them.
inline constexpr double leastTensorTurn = 70.5;
inline constexpr double largestTensorTurn = 140;
// So much (degrees) a corner's walls may lean against the side that its ridge ends at: the grid leans with it.
inline constexpr double largestLeanAtSide = 20;

// So much (degrees) columns between three walls may lean: as they do on two that enclose 60 degrees and stand on the
// third. There are the most of them, and where they lean more the single column is better.
inline constexpr double largestLeanBetweenThree = 30;

struct TensorCorner
{
  Index column = None;
  int walls = 0;                   // 2 or 3
  std::array<int, 3> patch{};      // whose heights the levels above each wall have
  std::array<Vector3, 3> normal{}; // of each wall at the point, unit, into the fluid
  std::array<Vector3, 3> rise{};   // the step that rises by one above that wall and stays in the others

  // The step that rises by one above all walls.
  Vector3 diagonal() const { return withoutThird(rise[0] + rise[1]); }
  // Of the corner's walls, the one that a face with this normal belongs to.
  int wallOf(const Vector3& faceNormal) const;

private:
  Vector3 withoutThird(const Vector3& sum) const { return walls == 3 ? sum + rise[2] : sum; }
};

// Do the faces around the point make such a corner? sideNormals are those of the adjoining patches that the
// column stays in. The ring may be rotated.
bool findTensorCorner(const Vector3& point, const TetMesh& mesh, FaceRing& ring,
  const std::vector<Vector3>& sideNormals, TensorCorner& corner);
} // namespace ransmesh

// The front's faces around a root whose fan is to be opened, and the columns that will lift them.
#pragma once

#include "Layers/Column.h"
#include "Mesh/TetMesh.h"
#include "Mesh/Traversal.h"

#include <vector>

namespace ransmesh
{
// The fluid's row of the patch table: boundary faces of the front without a triangle on the wall.
inline constexpr int FrontOnly = 0;

// Is a boundary face at the column's top part of the front, and not of a side?
inline bool isFrontFace(const TetMesh& mesh, const Column& column, Index boundaryFace)
{
  return !column.staysIn(mesh.boundaryFace(boundaryFace).patch);
}

// Visits the front's faces at the column's top, which ball surrounds: visit(boundary face, its vertices turned into
// the fluid, the top first).
template <class Visit>
void forEachFrontFaceAt(
  const TetMesh& mesh, const Column& column, const std::vector<Index>& ball, Visit visit)
{
  for (const Index t : ball)
  {
    for (int f = 0; f < 4; ++f)
    {
      const HalfFace beyond = mesh.tet(t).neighbour[f];
      if (isBoundary(beyond) && mesh.tet(t).vertex[f] != column.vertex &&
        isFrontFace(mesh, column, boundaryFaceOf(beyond)))
      {
        auto v = mesh.tet(t).face(f);
        while (v[0] != column.vertex)
        {
          v = { v[1], v[2], v[0] };
        }
        visit(boundaryFaceOf(beyond), v);
      }
    }
  }
}

class FanFaces
{
public:
  FanFaces(const TetMesh& mesh, const ColumnSet& set)
    : mesh_(mesh)
    , set_(set)
    , traversal_(mesh)
  {
  }

  // Which boundary faces each column of the fan lifts, the main one last: the wall's by the plan, those of
  // neighbouring fans by direction. False if the faces are not what the plan says.
  bool assign(const Fan& fan, std::vector<std::vector<Index>>& lifted);

private:
  // A face at the root, turned into the fluid: (root, second, third).
  struct FrontFace
  {
    Index face;
    Index second;
    Index third;
  };

  std::vector<FrontFace> facesAround(const Fan& fan);
  std::size_t nearestStep(const Fan& fan, std::size_t first, std::size_t last, const FrontFace& face) const;
  Vector3 directionOf(const Fan& fan, int number) const;
  Vector3 directionAt(Index vertex) const;
  Vector3 baseAt(Index vertex) const;

  const TetMesh& mesh_;
  const ColumnSet& set_;
  Traversal traversal_;
  std::vector<Index> ball_;
};
} // namespace ransmesh

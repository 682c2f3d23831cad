#include "Mesh/Collapse.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
// Takes out a tetrahedron at the edge (v, u): the neighbours beyond its faces opposite to them meet.
void closeUp(TetMesh& mesh, Index t, int cornerOfV, int cornerOfU)
{
  const Tetrahedron tet = mesh.tet(t);
  const HalfFace outer = tet.neighbour[cornerOfV];
  const HalfFace inner = tet.neighbour[cornerOfU];
  mesh.link(outer, inner);
  const Index remains = tetOf(isBoundary(outer) ? inner : outer);
  for (int f = 0; f < 4; ++f)
  {
    if (f != cornerOfV)
    {
      mesh.setVertexTet(tet.vertex[f], remains);
    }
    if (f != cornerOfV && f != cornerOfU && isBoundary(tet.neighbour[f]))
    {
      mesh.freeBoundaryFace(boundaryFaceOf(tet.neighbour[f]));
    }
  }
  mesh.freeTet(t);
}
} // namespace

bool canCollapse(const TetMesh& mesh, std::span<const Index> ball, Index v, Index u)
{
  return std::none_of(ball.begin(), ball.end(),
    [&](Index t)
    {
      const Tetrahedron& tet = mesh.tet(t);
      const int corner = tet.cornerOf(u);
      return corner >= 0 && isBoundary(tet.neighbour[corner]) && isBoundary(tet.neighbour[tet.cornerOf(v)]);
    });
}

void collapse(TetMesh& mesh, std::span<const Index> ball, Index v, Index u)
{
  for (const Index t : ball)
  {
    const int cornerOfV = mesh.tet(t).cornerOf(v);
    const int cornerOfU = mesh.tet(t).cornerOf(u);
    if (cornerOfU < 0)
    {
      mesh.setVertex(t, cornerOfV, u);
    }
    else
    {
      closeUp(mesh, t, cornerOfV, cornerOfU);
    }
  }
  mesh.setVertexTet(v, None);
}
} // namespace ransmesh

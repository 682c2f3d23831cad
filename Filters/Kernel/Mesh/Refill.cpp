#include "Mesh/Refill.h"

#include "Mesh/LocalNumbers.h"

#include <algorithm>
#include <map>

namespace ransmesh
{
namespace
{
using Corners = std::array<Index, 3>;

Corners inOrder(Corners corners)
{
  std::sort(corners.begin(), corners.end());
  return corners;
}
} // namespace

std::vector<RimFace> rimOf(const TetMesh& mesh, std::span<const Index> tets)
{
  LocalMarks inside;
  for (const Index t : tets)
  {
    inside.set(t);
  }
  std::vector<RimFace> rim;
  for (const Index t : tets)
  {
    const Tetrahedron& tet = mesh.tet(t);
    for (int f = 0; f < 4; ++f)
    {
      const HalfFace beyond = tet.neighbour[f];
      if (isBoundary(beyond) || !inside.test(tetOf(beyond)))
      {
        rim.push_back({ tet.face(f), beyond });
      }
    }
  }
  return rim;
}

std::vector<Index> refill(
  TetMesh& mesh, std::span<const Index> tets, std::span<const std::array<Index, 4>> fresh)
{
  std::map<Corners, HalfFace> waiting; // faces that have one side so far
  for (const RimFace& face : rimOf(mesh, tets))
  {
    waiting.emplace(inOrder(face.vertex), face.beyond);
  }
  for (const Index t : tets)
  {
    for (const Index v : mesh.tet(t).vertex)
    {
      mesh.setVertexTet(v, None);
    }
  }
  for (const Index t : tets)
  {
    mesh.freeTet(t);
  }
  std::vector<Index> made;
  for (const auto& vertices : fresh)
  {
    const Index t = mesh.addTet(vertices);
    made.push_back(t);
    for (int f = 0; f < 4; ++f)
    {
      const HalfFace side = halfFace(t, f);
      const auto [place, isFirst] = waiting.emplace(inOrder(mesh.tet(t).face(f)), side);
      if (!isFirst)
      {
        mesh.link(side, place->second);
        waiting.erase(place);
      }
    }
  }
  return made;
}
} // namespace ransmesh

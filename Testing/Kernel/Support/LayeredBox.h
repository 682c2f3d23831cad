// A box of tetrahedra whose levels above its floor can be chosen: layers made by hand.
#pragma once

#include "Mesh/FaceMatching.h"
#include "Mesh/MeshData.h"
#include "Mesh/TetMesh.h"
#include "Support/Patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace layered_box
{
using ransmesh::Index;
using ransmesh::MeshData;
using ransmesh::Vector3;

// Patches of the box: the floor is a wall, the lid a far field, the four sides symmetry planes.
enum PatchNumber
{
  Floor = 1,
  Lid,
  West,
  East,
  South,
  North
};

inline ransmesh::PatchTable patches()
{
  using ransmesh::PatchType;
  return { { "fluid", PatchType::Patch }, { "floor", PatchType::Wall }, { "lid", PatchType::FarField },
    { "west", PatchType::Symmetry }, { "east", PatchType::Symmetry }, { "south", PatchType::Symmetry },
    { "north", PatchType::Symmetry } };
}

// Heights of levels: firstHeight growing by growth, layers times, then the same again up to top.
inline std::vector<double> levels(double firstHeight, double growth, int layers, double top)
{
  std::vector<double> z = { 0 };
  double step = firstHeight;
  for (int i = 0; i < layers; ++i, step *= growth)
  {
    z.push_back(z.back() + step);
  }
  z.push_back(top);
  return z;
}

// The six tetrahedra of a cube that share its diagonal, by the order in which the axes are walked.
inline void addCube(MeshData& mesh, const std::array<Index, 8>& corner)
{
  constexpr int orders[6][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 }, { 1, 0, 2 }, { 0, 2, 1 },
    { 2, 1, 0 } };
  for (int i = 0; i < 6; ++i)
  {
    const int second = 1 << orders[i][0];
    const int third = second | (1 << orders[i][1]);
    std::array<Index, 4> tet = { corner[0], corner[second], corner[third], corner[7] };
    if (i >= 3)
    {
      std::swap(tet[1], tet[2]);
    }
    mesh.tetrahedra.push_back(tet);
  }
}

inline int patchAt(const std::array<Vector3, 3>& p, double lengthX, double lengthY)
{
  const auto all = [&p](int axis, double value)
  { return std::all_of(p.begin(), p.end(), [&](const Vector3& q) { return q[axis] == value; }); };
  return all(2, 0)    ? Floor
    : all(0, 0)       ? West
    : all(0, lengthX) ? East
    : all(1, 0)       ? South
    : all(1, lengthY) ? North
                      : Lid;
}

// Triangles on every face that has one tetrahedron only.
inline void addBoundary(MeshData& mesh, double lengthX, double lengthY)
{
  const ransmesh::FaceMatching matching = matchFaces(mesh);
  std::vector<std::array<Index, 3>> byPatch[7];
  for (std::size_t face = 0; face < matching.opposite.size(); ++face)
  {
    if (matching.opposite[face] == ransmesh::FaceMatching::Unmatched)
    {
      const auto& tet = mesh.tetrahedra[face / 4];
      const int* c = ransmesh::FaceCorners[face % 4];
      const std::array<Index, 3> outward = { tet[c[0]], tet[c[2]], tet[c[1]] };
      const int patch = patchAt(
        { mesh.points[outward[0]], mesh.points[outward[1]], mesh.points[outward[2]] }, lengthX, lengthY);
      byPatch[patch].push_back(outward);
    }
  }
  for (int patch = Floor; patch <= North; ++patch)
  {
    mesh.triangles.insert(mesh.triangles.end(), byPatch[patch].begin(), byPatch[patch].end());
    mesh.trianglePatch.insert(mesh.trianglePatch.end(), byPatch[patch].size(), patch);
  }
}

// nx by ny cubes of the given size on the floor, with points at each of the levels.
inline MeshData make(int nx, int ny, double size, const std::vector<double>& z)
{
  MeshData mesh;
  const auto nz = static_cast<int>(z.size()) - 1;
  const auto number = [=](int i, int j, int k)
  { return static_cast<Index>((k * (ny + 1) + j) * (nx + 1) + i); };
  for (int k = 0; k <= nz; ++k)
  {
    for (int j = 0; j <= ny; ++j)
    {
      for (int i = 0; i <= nx; ++i)
      {
        mesh.points.push_back({ i * size, j * size, z[k] });
      }
    }
  }
  for (int k = 0; k < nz; ++k)
  {
    for (int j = 0; j < ny; ++j)
    {
      for (int i = 0; i < nx; ++i)
      {
        std::array<Index, 8> corner;
        for (int c = 0; c < 8; ++c)
        {
          corner[c] = number(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2));
        }
        addCube(mesh, corner);
      }
    }
  }
  addBoundary(mesh, nx * size, ny * size);
  return mesh;
}
} // namespace layered_box

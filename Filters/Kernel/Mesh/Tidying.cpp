#include "Mesh/Tidying.h"

#include "Mesh/TetMesh.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace ransmesh
{
void sortByPatch(MeshData& mesh)
{
  std::vector<Index> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](Index i, Index j) { return mesh.trianglePatch[i] < mesh.trianglePatch[j]; });
  MeshData sorted;
  for (const Index i : order)
  {
    sorted.triangles.push_back(mesh.triangles[i]);
    sorted.trianglePatch.push_back(mesh.trianglePatch[i]);
  }
  mesh.triangles = std::move(sorted.triangles);
  mesh.trianglePatch = std::move(sorted.trianglePatch);
}

void renumberCorners(const std::vector<Index>& number, MeshData& mesh)
{
  const auto renumber = [&number](auto& cells)
  {
    for (auto& cell : cells)
    {
      for (Index& v : cell)
      {
        v = number[v];
      }
    }
  };
  renumber(mesh.tetrahedra);
  renumber(mesh.triangles);
}

void dropUnusedPoints(MeshData& mesh)
{
  std::vector<Index> number(mesh.points.size(), None);
  for (const auto& tet : mesh.tetrahedra)
  {
    for (const Index v : tet)
    {
      number[v] = 0;
    }
  }
  Index used = 0;
  for (std::size_t v = 0; v < number.size(); ++v)
  {
    if (number[v] != None)
    {
      mesh.points[used] = mesh.points[v];
      number[v] = used++;
    }
  }
  mesh.points.resize(used);
  renumberCorners(number, mesh);
}

void turnOutward(MeshData& mesh, const FaceMatching& matching)
{
  for (std::size_t face = 0; face < matching.opposite.size(); ++face)
  {
    const Index other = matching.opposite[face];
    if (other >= 0 || other == FaceMatching::Unmatched)
    {
      continue;
    }
    auto& triangle = mesh.triangles[boundaryFaceOf(other)];
    const auto& tet = mesh.tetrahedra[face / 4];
    const int* corner = FaceCorners[face % 4];
    for (int i = 0; i < 3; ++i)
    {
      if (triangle[i] == tet[corner[0]] && triangle[(i + 1) % 3] == tet[corner[1]])
      {
        std::swap(triangle[1], triangle[2]);
        break;
      }
    }
  }
}
} // namespace ransmesh

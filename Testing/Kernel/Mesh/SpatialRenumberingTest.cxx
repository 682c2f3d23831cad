#include "Mesh/SpatialRenumbering.h"

#include "Mesh/Validation.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace
{
using namespace ransmesh;

// The same mesh with its points in random order.
MeshData shuffled(MeshData mesh)
{
  std::vector<Index> number(mesh.points.size());
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin(), number.end(), std::mt19937(7));
  const std::vector<Vector3> points = mesh.points;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    mesh.points[number[i]] = points[i];
  }
  const auto renumber = [&number](auto& cell)
  { std::transform(cell.begin(), cell.end(), cell.begin(), [&number](Index v) { return number[v]; }); };
  std::for_each(mesh.tetrahedra.begin(), mesh.tetrahedra.end(), renumber);
  std::for_each(mesh.triangles.begin(), mesh.triangles.end(), renumber);
  return mesh;
}

// Mean difference of the numbers in a tetrahedron: how far it reaches in memory.
double reach(const MeshData& mesh)
{
  double sum = 0;
  for (const auto& tet : mesh.tetrahedra)
  {
    const auto [low, high] = std::minmax_element(tet.begin(), tet.end());
    sum += *high - *low;
  }
  return sum / static_cast<double>(mesh.tetrahedra.size());
}

TEST(SpatialRenumbering, KeepsTheMeshAndBringsNeighboursTogether)
{
  const MeshData before = shuffled(grid_mesh::make({ 12, 12, 12, {}, 0.1 }));
  MeshData after = before;
  renumberSpatially(after);
  EXPECT_TRUE(findFaults(after).none()) << findFaults(after).text();
  EXPECT_EQ(after.points.size(), before.points.size());
  EXPECT_EQ(after.tetrahedra.size(), before.tetrahedra.size());
  EXPECT_NEAR(totalVolume(after), totalVolume(before), 1e-13);
  EXPECT_LT(reach(after), 0.5 * reach(before));
}

TEST(SpatialRenumbering, KeepsTrianglesWithTheirPatches)
{
  MeshData mesh = shuffled(grid_mesh::make({ 4, 4, 4 }));
  renumberSpatially(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (mesh.trianglePatch[t] == grid_mesh::ZHigh)
    {
      for (const Index v : mesh.triangles[t])
      {
        EXPECT_EQ(mesh.points[v].z, 1);
      }
    }
  }
  EXPECT_EQ(std::count(mesh.trianglePatch.begin(), mesh.trianglePatch.end(), grid_mesh::ZHigh), 32);
}

TEST(SpatialRenumbering, PutsCellsInOrderOfTheirSmallestPoint)
{
  MeshData mesh = shuffled(grid_mesh::make({ 4, 4, 4 }));
  renumberSpatially(mesh);
  const auto smallest = [](const auto& cell) { return *std::min_element(cell.begin(), cell.end()); };
  const auto inOrder = [&](const auto& a, const auto& b) { return smallest(a) < smallest(b); };
  EXPECT_TRUE(std::is_sorted(mesh.tetrahedra.begin(), mesh.tetrahedra.end(), inOrder));
  EXPECT_TRUE(std::is_sorted(mesh.triangles.begin(), mesh.triangles.end(), inOrder));
}
} // namespace

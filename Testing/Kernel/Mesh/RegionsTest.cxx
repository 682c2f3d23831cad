#include "Mesh/Regions.h"

#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using namespace ransmesh;

int countRegions(const MeshData& mesh)
{
  const std::vector<int> region = numberRegions(mesh);
  EXPECT_EQ(region.size(), mesh.tetrahedra.size());
  EXPECT_EQ(*std::min_element(region.begin(), region.end()), 1);
  return *std::max_element(region.begin(), region.end());
}

TEST(Regions, AreDividedByClosedSheetsOnly)
{
  MeshData mesh = grid_mesh::make({ 4, 4, 4 });
  EXPECT_EQ(countRegions(mesh), 1);
  grid_mesh::addSheet(mesh, [](const Vector3& m) { return m.x == 0.5 && m.y < 0.6; });
  EXPECT_EQ(countRegions(mesh), 1);
  mesh = grid_mesh::make({ 4, 4, 4 });
  grid_mesh::addSheet(mesh, [](const Vector3& m) { return m.x == 0.5; });
  EXPECT_EQ(countRegions(mesh), 2);
}

TEST(Regions, LieApart)
{
  MeshData mesh = grid_mesh::make({ 6, 2, 2 });
  grid_mesh::carve(mesh, [](const Vector3& m) { return m.x > 0.34 && m.x < 0.66; });
  const std::vector<int> region = numberRegions(mesh);
  for (std::size_t t = 0; t < region.size(); ++t)
  {
    const double x = mesh.points[mesh.tetrahedra[t][0]].x;
    EXPECT_EQ(region[t], (x < 0.5) == (mesh.points[mesh.tetrahedra[0][0]].x < 0.5) ? 1 : 2);
  }
}
} // namespace

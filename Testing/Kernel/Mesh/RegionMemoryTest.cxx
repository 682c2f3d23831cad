#include "Mesh/RegionMemory.h"

#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace
{
using namespace ransmesh;

// The cube, divided at x = 0.25 and x = 0.5.
MeshData dividedCube()
{
  MeshData mesh = grid_mesh::make({ 4, 2, 2 });
  grid_mesh::addSheet(mesh, [](const Vector3& m) { return m.x == 0.25 || m.x == 0.5; });
  return mesh;
}

// 5 below x = 0.25, 9 up to 0.5, 2 beyond.
std::vector<int> regionsByPlace(const MeshData& mesh)
{
  std::vector<int> regions;
  for (const auto& tet : mesh.tetrahedra)
  {
    double x = 0;
    std::for_each(tet.begin(), tet.end(), [&](Index v) { x += mesh.points[v].x / 4; });
    regions.push_back(x < 0.25 ? 5 : x < 0.5 ? 9 : 2);
  }
  return regions;
}

std::vector<Index> asTheyAre(const MeshData& mesh)
{
  std::vector<Index> origin(mesh.points.size());
  std::iota(origin.begin(), origin.end(), 0);
  return origin;
}

TEST(RegionMemory, TellsRegionsByTheirPoints)
{
  const MeshData mesh = dividedCube(); // the region in the middle has no points of its own
  const RegionMemory memory(mesh, regionsByPlace(mesh));
  MeshData other = mesh;
  std::reverse(other.tetrahedra.begin(), other.tetrahedra.end());
  EXPECT_EQ(memory.recall(other, asTheyAre(other)), regionsByPlace(other));
}

TEST(RegionMemory, TellsRegionsOfNewPoints)
{
  const MeshData mesh = dividedCube();
  const RegionMemory memory(mesh, regionsByPlace(mesh));
  MeshData other = mesh; // each tetrahedron gets a point amid
  std::vector<Index> origin = asTheyAre(mesh);
  other.tetrahedra.clear();
  for (const auto& v : mesh.tetrahedra)
  {
    const auto& p = mesh.points;
    const auto middle = static_cast<Index>(other.points.size());
    other.points.push_back(0.25 * (p[v[0]] + p[v[1]] + p[v[2]] + p[v[3]]));
    origin.push_back(v[0]);
    other.tetrahedra.insert(other.tetrahedra.end(),
      { { v[0], v[1], v[2], middle }, { v[0], v[1], middle, v[3] }, { v[0], middle, v[2], v[3] },
        { middle, v[1], v[2], v[3] } });
  }
  EXPECT_EQ(memory.recall(other, origin), regionsByPlace(other));
}

TEST(RegionMemory, OneRegionOrNone)
{
  const MeshData mesh = grid_mesh::make({ 2, 2, 2 });
  EXPECT_TRUE(RegionMemory().recall(mesh, asTheyAre(mesh)).empty());
  const std::vector<int> three(mesh.tetrahedra.size(), 3);
  EXPECT_EQ(RegionMemory(mesh, three).recall(mesh, asTheyAre(mesh)), three);
}

TEST(RegionMemory, WhatTrianglesDoNotDivideIsOne)
{
  const MeshData mesh = grid_mesh::make({ 4, 2, 2 });
  const std::vector<int> now = RegionMemory(mesh, regionsByPlace(mesh)).recall(mesh, asTheyAre(mesh));
  EXPECT_EQ(now, std::vector<int>(mesh.tetrahedra.size(), 2)); // which is the largest
}
} // namespace

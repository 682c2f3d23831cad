#include "Prisms/Orthogonality.h"

#include "Mesh/Validation.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

namespace
{
using namespace ransmesh;

constexpr int Cells = 6;

MeshData jittered()
{
  return grid_mesh::make({ Cells, Cells, Cells, {}, 0.25 });
}

std::vector<Index> noPrisms(const MeshData& mesh)
{
  return std::vector<Index>(mesh.tetrahedra.size(), None);
}

OrthogonalityReport improve(MeshData& mesh, const std::vector<Index>& prism, double limit)
{
  const OrthogonalityReport report = improveOrthogonality(mesh, matchFaces(mesh), prism, limit);
  const MeshFaults faults = findFaults(mesh);
  EXPECT_TRUE(faults.none()) << faults.text();
  return report;
}
} // namespace

TEST(Orthogonality, PointsMoveUntilFacesAreBelowTheLimit)
{
  MeshData mesh = jittered();
  const std::vector<Index> prism = noPrisms(mesh);
  const OrthogonalityReport before = improveOrthogonality(mesh, matchFaces(mesh), prism, 90);
  ASSERT_GT(before.largest, 60);
  ASSERT_EQ(before.movedPoints, 0U);
  const OrthogonalityReport after = improve(mesh, prism, 58);
  EXPECT_GT(after.movedPoints, 0U);
  EXPECT_LT(after.largest, 58);
  EXPECT_EQ(after.facesOver, 0U);
}

TEST(Orthogonality, PointsOfPrismsAndOfTheBoundaryStay)
{
  MeshData mesh = jittered();
  const MeshData before = mesh;
  std::vector<Index> prism = noPrisms(mesh);
  std::vector<char> mayMove(mesh.points.size(), 1);
  for (std::size_t t = 0; t < prism.size(); t += 5)
  {
    prism[t] = static_cast<Index>(t);
    for (const Index v : mesh.tetrahedra[t])
    {
      mayMove[v] = 0;
    }
  }
  for (const auto& triangle : mesh.triangles)
  {
    for (const Index v : triangle)
    {
      mayMove[v] = 0;
    }
  }
  improve(mesh, prism, 40);
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    if (!mayMove[v])
    {
      EXPECT_EQ(mesh.points[v], before.points[v]);
    }
  }
}

TEST(Orthogonality, WhatIsBelowTheLimitStays)
{
  MeshData mesh = jittered();
  const MeshData before = mesh;
  EXPECT_EQ(improve(mesh, noPrisms(mesh), 90).movedPoints, 0U);
  EXPECT_EQ(mesh.points, before.points);
}

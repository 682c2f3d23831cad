#include "Mesh/FaceMatching.h"

#include "Mesh/TetMesh.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

namespace
{
using namespace ransmesh;

// Tetrahedra between one edge and a chain of points around it: the edge's vertices have the smallest numbers,
// so that nearly all faces share a smallest vertex.
MeshData wheel(int spokes)
{
  MeshData mesh;
  mesh.points.resize(static_cast<std::size_t>(spokes) + 3);
  for (Index i = 0; i < spokes; ++i)
  {
    mesh.tetrahedra.push_back({ 0, 1, 2 + i, 3 + i });
  }
  return mesh;
}

void expectMutual(const FaceMatching& matching)
{
  for (std::size_t face = 0; face < matching.opposite.size(); ++face)
  {
    const Index other = matching.opposite[face];
    if (other >= 0)
    {
      EXPECT_EQ(matching.opposite[other], static_cast<Index>(face));
    }
  }
}

TEST(FaceMatching, FindsTheOtherSideOfEveryFace)
{
  const MeshData mesh = grid_mesh::make({ 5, 4, 3 });
  const FaceMatching matching = matchFaces(mesh);
  EXPECT_TRUE(matching.ok());
  expectMutual(matching);
  std::vector<int> covered(mesh.triangles.size(), 0);
  for (const Index other : matching.opposite)
  {
    EXPECT_NE(other, FaceMatching::Unmatched);
    if (isBoundary(other))
    {
      ++covered[boundaryFaceOf(other)];
    }
  }
  EXPECT_EQ(covered, std::vector<int>(mesh.triangles.size(), 1));
}

TEST(FaceMatching, CopesWithVerticesOfAnyNumberOfFaces)
{
  for (const int spokes : { 1, 50, 84, 85, 86, 2000 })
  {
    const FaceMatching matching = matchFaces(wheel(spokes));
    expectMutual(matching);
    EXPECT_EQ(matching.facesWithoutTriangle, 2u * spokes + 2u) << spokes; // two a tetrahedron, and the ends
    for (int i = 0; i + 1 < spokes; ++i)
    {
      EXPECT_EQ(matching.opposite[4 * i + 2], 4 * (i + 1) + 3); // opposite to corner 2 and to corner 3
    }
  }
}

TEST(FaceMatching, LeavesFacesOfMoreThanTwoTetsOpen)
{
  for (const int copies : { 3, 4 })
  {
    MeshData mesh;
    mesh.points.resize(3 + static_cast<std::size_t>(copies));
    for (Index i = 0; i < copies; ++i)
    {
      mesh.tetrahedra.push_back({ 0, 1, 2, 3 + i });
    }
    const FaceMatching matching = matchFaces(mesh);
    EXPECT_EQ(matching.facesInMoreThanTwoTets, 1u);
    EXPECT_EQ(matching.firstFaultyTet, 0);
    for (Index i = 0; i < copies; ++i)
    {
      EXPECT_EQ(matching.opposite[4 * i + 3], FaceMatching::Unmatched);
    }
  }
}

TEST(FaceMatching, CountsTrianglesGivenTwice)
{
  MeshData mesh = grid_mesh::make({ 3, 3, 3 });
  mesh.triangles.push_back(mesh.triangles[4]);
  mesh.trianglePatch.push_back(mesh.trianglePatch[4]);
  mesh.triangles.push_back({ 0, 40, 63 }); // where no face is
  mesh.trianglePatch.push_back(1);
  const FaceMatching matching = matchFaces(mesh);
  EXPECT_EQ(matching.repeatedTriangles, 1u);
  EXPECT_EQ(matching.trianglesOffTheBoundary, 1u);
  EXPECT_EQ(matching.facesWithoutTriangle, 0u);
}
} // namespace

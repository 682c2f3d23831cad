#include "Mesh/Validation.h"

#include "Mesh/Builder.h"
#include "Support/GridMesh.h"
#include "Support/Invariants.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace ransmesh;

class Validation : public testing::Test
{
protected:
  // Expects exactly the faults named to be found, and the mesh to be refused with text about them.
  MeshFaults expectFault(const char* text)
  {
    const MeshFaults faults = findFaults(mesh_);
    EXPECT_FALSE(faults.none());
    EXPECT_NE(faults.text().find(text), std::string::npos) << faults.text();
    TetMesh built;
    const Outcome outcome = buildTetMesh(mesh_, built);
    EXPECT_EQ(outcome.kind, Outcome::Kind::BadInput);
    EXPECT_NE(outcome.message.find(text), std::string::npos) << outcome.message;
    EXPECT_EQ(built.tetSlots(), 0u);
    return faults;
  }

  MeshData mesh_ = grid_mesh::make({ 3, 2, 2, {}, 0.1 });
};

TEST_F(Validation, FindsNothingInAValidMesh)
{
  EXPECT_TRUE(findFaults(mesh_).none());
  EXPECT_NEAR(totalVolume(mesh_), 1, 1e-14);
}

TEST_F(Validation, FindsNumbersOutOfRange)
{
  mesh_.tetrahedra[5][2] = static_cast<Index>(mesh_.points.size());
  mesh_.triangles[3][0] = -1;
  const MeshFaults faults = expectFault("point numbers out of range");
  EXPECT_EQ(faults.indicesOutOfRange, 2u);
  EXPECT_EQ(faults.firstTet, 5);
  EXPECT_EQ(faults.firstTriangle, 3);
}

TEST_F(Validation, FindsPointsThatAreNotFinite)
{
  mesh_.points[7].y = std::nan("");
  EXPECT_EQ(expectFault("not finite").firstPoint, 7);
}

TEST_F(Validation, FindsCoincidentPoints)
{
  mesh_.points[4] = mesh_.points[5];
  EXPECT_EQ(expectFault("coincident points").pointsCoincident, 1u);
}

TEST_F(Validation, FindsUnusedPoints)
{
  mesh_.points.push_back({ 5, 5, 5 });
  EXPECT_EQ(expectFault("unused points").pointsUnused, 1u);
}

TEST_F(Validation, FindsTetrahedraThatAreNotPositive)
{
  std::swap(mesh_.tetrahedra[9][0], mesh_.tetrahedra[9][1]);
  const MeshFaults faults = expectFault("not positive");
  EXPECT_EQ(faults.tetsNotPositive, 1u);
  EXPECT_EQ(faults.firstTet, 9);
}

TEST_F(Validation, FindsTetrahedraThatAreThereTwice)
{
  mesh_.tetrahedra.push_back(mesh_.tetrahedra[20]);
  EXPECT_GE(expectFault("faces in more than two tetrahedra").facesInMoreThanTwoTets, 1u);
}

TEST_F(Validation, FindsMissingTriangles)
{
  mesh_.triangles.pop_back();
  mesh_.trianglePatch.pop_back();
  EXPECT_EQ(expectFault("without a triangle").facesWithoutTriangle, 1u);
}

TEST_F(Validation, FindsTrianglesOffTheBoundary)
{
  mesh_.triangles.push_back({ 0, 1, static_cast<Index>(mesh_.points.size() - 1) });
  mesh_.trianglePatch.push_back(1);
  EXPECT_EQ(expectFault("off the boundary").trianglesOffTheBoundary, 1u);
}

TEST_F(Validation, FindsRepeatedTriangles)
{
  mesh_.triangles.push_back(mesh_.triangles[2]);
  mesh_.trianglePatch.push_back(1);
  EXPECT_EQ(expectFault("repeated triangles").repeatedTriangles, 1u);
}

TEST_F(Validation, FindsTrianglesTurnedInward)
{
  std::swap(mesh_.triangles[6][0], mesh_.triangles[6][1]);
  const MeshFaults faults = expectFault("turned inward");
  EXPECT_EQ(faults.trianglesTurnedInward, 1u);
  EXPECT_EQ(faults.firstTriangle, 6);
}

TEST_F(Validation, FindsBrokenLinks)
{
  TetMesh mesh = invariants::build(mesh_);
  Tetrahedron tet = mesh.tet(11);
  std::swap(tet.neighbour[0], tet.neighbour[1]);
  mesh.fillTet(11, tet);
  EXPECT_GT(findFaults(mesh).brokenLinks, 0u);
}

TEST_F(Validation, BuildingAndTakingApartKeepsEverything)
{
  std::vector<Index> number;
  const MeshData again = toMeshData(invariants::build(mesh_), &number);
  EXPECT_EQ(again.points, mesh_.points);
  EXPECT_EQ(again.tetrahedra, mesh_.tetrahedra);
  EXPECT_EQ(again.trianglePatch, mesh_.trianglePatch);
  EXPECT_EQ(invariants::patchAreas(again), invariants::patchAreas(mesh_));
  for (std::size_t v = 0; v < number.size(); ++v)
  {
    EXPECT_EQ(number[v], static_cast<Index>(v));
  }
}
} // namespace

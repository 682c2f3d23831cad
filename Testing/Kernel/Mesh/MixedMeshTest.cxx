#include "Mesh/MixedMesh.h"

#include "Mesh/MixedValidation.h"
#include "Mesh/Validation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace
{
using namespace ransmesh;

// A wedge, a pyramid upon one of its quadrilaterals, a tetrahedron upon its top, all sides one patch.
MixedMesh makeMixed()
{
  MixedMesh mesh;
  mesh.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 0, 1, 1 },
    { 0.5, -1, 0.5 }, { 0.3, 0.3, 2 } };
  mesh.wedges.push_back({ 0, 2, 1, 3, 5, 4 });
  mesh.pyramids.push_back({ 0, 1, 4, 3, 6 });
  mesh.tetrahedra.push_back({ 3, 4, 5, 7 });
  mesh.boundary = { { 0, 2, 1, None }, { 0, 3, 5, 2 }, { 1, 2, 5, 4 }, { 0, 6, 3, None }, { 3, 6, 4, None },
    { 4, 6, 1, None }, { 1, 6, 0, None }, { 3, 4, 7, None }, { 4, 5, 7, None }, { 5, 3, 7, None } };
  mesh.boundaryPatch.assign(mesh.boundary.size(), 1);
  return mesh;
}

// A way to renumber the points: which of them has the lowest number decides how cells are cut.
MixedMesh renumbered(const MixedMesh& mesh, const std::vector<Index>& number)
{
  MixedMesh result = mesh;
  for (std::size_t i = 0; i < number.size(); ++i)
  {
    result.points[number[i]] = mesh.points[i];
  }
  const auto apply = [&number](auto& cells)
  {
    for (auto& cell : cells)
    {
      for (Index& v : cell)
      {
        v = v == None ? None : number[v];
      }
    }
  };
  apply(result.tetrahedra);
  apply(result.pyramids);
  apply(result.wedges);
  apply(result.hexahedra);
  apply(result.boundary);
  return result;
}
} // namespace

TEST(MixedMesh, AValidOneHasNoFaults)
{
  const MixedFaults faults = findFaults(makeMixed());
  EXPECT_TRUE(faults.none()) << faults.text();
}

TEST(MixedMesh, EveryCutGivesTheSameVolumeInPositiveTetrahedra)
{
  std::vector<Index> number(8);
  std::iota(number.begin(), number.end(), 0);
  do
  {
    const MixedMesh mesh = renumbered(makeMixed(), number);
    const SplitMesh split = splitIntoTets(mesh);
    const MeshFaults faults = findFaults(split.mesh);
    ASSERT_TRUE(faults.none()) << faults.text();
    ASSERT_EQ(split.mesh.tetrahedra.size(), 6U);
    ASSERT_EQ(split.cell.size(), 6U);
    ASSERT_EQ(split.polygon.size(), split.mesh.triangles.size());
    ASSERT_NEAR(totalVolume(split.mesh), 0.5 + 1.0 / 3 + 1.0 / 6, 1e-12);
  } while (std::next_permutation(number.begin(), number.begin() + 6));
}

TEST(MixedMesh, EveryCutOfAHexahedronGivesItsVolume)
{
  MixedMesh mesh; // a cube, and a wedge beside it
  mesh.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 },
    { 0, 1, 1 }, { 2, 0, 0 }, { 2, 1, 0 } };
  mesh.hexahedra.push_back({ 0, 1, 2, 3, 4, 5, 6, 7 });
  mesh.wedges.push_back({ 1, 8, 5, 2, 9, 6 });
  mesh.boundary = { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 },
    { 1, 8, 5, None }, { 2, 6, 9, None }, { 1, 2, 9, 8 }, { 8, 9, 6, 5 } };
  mesh.boundaryPatch.assign(mesh.boundary.size(), 1);
  EXPECT_TRUE(findFaults(mesh).none()) << findFaults(mesh).text();
  std::vector<Index> number(mesh.points.size());
  std::iota(number.begin(), number.end(), 0);
  std::mt19937 random(1);
  for (int i = 0; i < 500; ++i)
  {
    const SplitMesh split = splitIntoTets(renumbered(mesh, number));
    const MeshFaults faults = findFaults(split.mesh);
    ASSERT_TRUE(faults.none()) << faults.text();
    ASSERT_NEAR(totalVolume(split.mesh), 1.5, 1e-12);
    std::shuffle(number.begin(), number.end(), random);
  }
  mesh.points[7] = { 0.6, 0.4, 0.4 }; // the corner comes through the opposite edge
  EXPECT_FALSE(isSound(mesh.hexahedra[0], mesh.points));
  EXPECT_EQ(findFaults(mesh).cellsNotSound, 1U);
}

TEST(MixedMesh, AnInvertedCornerIsNotSound)
{
  MixedMesh mesh = makeMixed();
  EXPECT_TRUE(isSound(mesh.wedges[0], mesh.points));
  mesh.points[5] = { 0, 1, -0.1 };
  EXPECT_FALSE(isSound(mesh.wedges[0], mesh.points));
  EXPECT_GT(findFaults(mesh).cellsNotSound, 0U);
  const Pyramid& pyramid = mesh.pyramids[0];
  EXPECT_TRUE(isSound(pyramid, mesh.points));
  mesh.points[6] = { 0.5, 1, 0.5 };
  EXPECT_FALSE(isSound(pyramid, mesh.points));
}

TEST(MixedMesh, AWedgeTurnedTheOtherWayIsNotSound)
{
  MixedMesh mesh = makeMixed();
  mesh.wedges[0] = { 0, 1, 2, 3, 4, 5 };
  EXPECT_EQ(findFaults(mesh).cellsNotSound, 1U);
}

TEST(MixedMesh, AQuadrilateralThatMeetsTwoTrianglesIsAFault)
{
  MixedMesh mesh = makeMixed();
  mesh.pyramids.clear();
  mesh.tetrahedra.push_back({ 0, 4, 3, 6 });
  mesh.tetrahedra.push_back({ 0, 1, 4, 6 });
  const MixedFaults faults = findFaults(mesh);
  EXPECT_EQ(faults.facesAlone, 3U);
  EXPECT_FALSE(faults.none());
}

TEST(MixedMesh, FaultsOfTheBoundaryAreFound)
{
  MixedMesh missing = makeMixed();
  missing.boundary.pop_back();
  missing.boundaryPatch.pop_back();
  EXPECT_EQ(findFaults(missing).facesAlone, 1U);

  MixedMesh inward = makeMixed();
  std::swap(inward.boundary[1][0], inward.boundary[1][2]);
  EXPECT_EQ(findFaults(inward).polygonsTurnedInward, 1U);

  MixedMesh twice = makeMixed();
  twice.boundary.push_back(twice.boundary[1]);
  twice.boundaryPatch.push_back(1);
  EXPECT_EQ(findFaults(twice).polygonsRepeated, 1U);

  MixedMesh inside = makeMixed(); // of a patch that lies on the boundary elsewhere
  inside.boundary.push_back({ 3, 4, 5, None });
  inside.boundaryPatch.push_back(1);
  EXPECT_EQ(findFaults(inside).polygonsOffTheBoundary, 1U);
  inside.boundaryPatch.back() = 2; // a sheet
  EXPECT_TRUE(findFaults(inside).none());
}

TEST(MixedMesh, PointNumbersOutOfRangeAndPointsNotFiniteAreFound)
{
  MixedMesh mesh = makeMixed();
  mesh.wedges[0][3] = 8;
  EXPECT_EQ(findFaults(mesh).indicesOutOfRange, 1U);
  mesh = makeMixed();
  mesh.points[0].x = std::nan("");
  EXPECT_EQ(findFaults(mesh).pointsNotFinite, 1U);
}

#include "Boundary/Classification.h"

#include "Support/GridMesh.h"
#include "Support/Invariants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using namespace ransmesh;
using grid_mesh::XLow;
using grid_mesh::ZLow;

// What a point of the unit cube is, by the number of sides that it lies in.
VertexKind kindInCube(const Vector3& p)
{
  int sides = 0;
  for (int i = 0; i < 3; ++i)
  {
    sides += p[i] == 0 || p[i] == 1;
  }
  return static_cast<VertexKind>(sides);
}

TEST(Classification, KnowsTheCubesFacesEdgesAndCorners)
{
  const TetMesh mesh = invariants::build(grid_mesh::make({ 4, 3, 5, {}, 0.1 }));
  const Classification c = classify(mesh, grid_mesh::patches(PatchType::Symmetry));
  for (Index v = 0; v < static_cast<Index>(mesh.vertexCount()); ++v)
  {
    const VertexKind expected = kindInCube(mesh.point(v));
    EXPECT_EQ(c.kind[v], expected);
    EXPECT_EQ(c.patchesAt(v).size(), static_cast<std::size_t>(expected));
    EXPECT_EQ(c.ridges.at(v).size(),
      expected == VertexKind::Ridge      ? 2u
        : expected == VertexKind::Corner ? 3u
                                         : 0u);
    EXPECT_FALSE(c.frozen[v]);
  }
}

TEST(Classification, FindsFeatureEdgesWithinAPatch)
{
  const auto onePatch = [](grid_mesh::Side, const Vector3&) { return 1; };
  const TetMesh mesh = invariants::build(grid_mesh::make({ 3, 3, 3 }, onePatch));
  const Classification c = classify(mesh, grid_mesh::patches(PatchType::Wall, 1));
  for (Index v = 0; v < static_cast<Index>(mesh.vertexCount()); ++v)
  {
    EXPECT_EQ(c.kind[v], kindInCube(mesh.point(v)));
  }
  const Classification blunt = classify(mesh, grid_mesh::patches(PatchType::Wall, 1), 100);
  EXPECT_EQ(std::count(blunt.kind.begin(), blunt.kind.end(), VertexKind::Ridge), 0);
  EXPECT_EQ(std::count(blunt.kind.begin(), blunt.kind.end(), VertexKind::Corner), 0);
}

TEST(Classification, CallsKinksAndEndsOfRidgesCorners)
{
  // A second patch fills one quarter of the floor: its border has a kink, and ends at the floor's edges.
  const auto quarter = [](grid_mesh::Side side, const Vector3& p)
  { return side == ZLow && p.x < 0.5 && p.y < 0.5 ? 7 : static_cast<int>(side); };
  const TetMesh mesh = invariants::build(grid_mesh::make({ 4, 4, 2 }, quarter));
  const Classification c = classify(mesh, grid_mesh::patches(PatchType::Symmetry, 7));
  for (Index v = 0; v < static_cast<Index>(mesh.vertexCount()); ++v)
  {
    const Vector3& p = mesh.point(v);
    if (p == Vector3{ 0.5, 0.5, 0 } || p == Vector3{ 0.5, 0, 0 } || p == Vector3{ 0, 0.5, 0 })
    {
      EXPECT_EQ(c.kind[v], VertexKind::Corner);
    }
    if (p == Vector3{ 0.25, 0.5, 0 })
    {
      EXPECT_EQ(c.kind[v], VertexKind::Ridge);
    }
  }
}

TEST(Classification, FreezesInterfaces)
{
  const TetMesh mesh = invariants::build(grid_mesh::make({ 3, 3, 3 }));
  PatchTable patches = grid_mesh::patches(PatchType::Symmetry);
  patches[XLow].type = PatchType::Interface;
  const Classification c = classify(mesh, patches);
  for (Index v = 0; v < static_cast<Index>(mesh.vertexCount()); ++v)
  {
    EXPECT_EQ(c.frozen[v] != 0, mesh.point(v).x == 0);
  }
}

TEST(Classification, CallsPointsWhereSurfacesOnlyTouchCorners)
{
  MeshData data;
  data.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { -1, 0, 0 }, { 0, -1, 0 },
    { 0, 0, -1 } };
  data.tetrahedra = { { 0, 1, 2, 3 }, { 0, 5, 4, 6 } };
  for (const auto& t : data.tetrahedra)
  {
    for (const auto& f : FaceCorners)
    {
      data.triangles.push_back({ t[f[0]], t[f[2]], t[f[1]] });
      data.trianglePatch.push_back(1);
    }
  }
  const TetMesh mesh = invariants::build(data);
  const Classification c = classify(mesh, grid_mesh::patches(PatchType::Wall, 1), 180);
  EXPECT_EQ(c.kind[0], VertexKind::Corner);
  EXPECT_EQ(c.kind[1], VertexKind::Surface);
}

TEST(Ridges, ChangeAsEdgesComeAndGo)
{
  Ridges ridges;
  ridges.add(3, 5);
  ridges.add(5, 3);
  ridges.add(5, 9);
  EXPECT_TRUE(ridges.has(3, 5));
  EXPECT_TRUE(ridges.has(9, 5));
  EXPECT_FALSE(ridges.has(3, 9));
  EXPECT_EQ(ridges.at(5).size(), 2u);
  ridges.remove(3, 5);
  ridges.remove(3, 9);
  EXPECT_TRUE(ridges.at(3).empty());
  EXPECT_EQ(ridges.at(5).size(), 1u);
  EXPECT_TRUE(ridges.at(100).empty());
}
} // namespace

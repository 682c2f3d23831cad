#include "Improvement/FlatTetrahedra.h"

#include "Geometry/Predicates.h"
#include "Mesh/Validation.h"

#include <gtest/gtest.h>

#include <utility>

using namespace ransmesh;

namespace
{
void add(MeshData& mesh, std::array<Index, 4> t)
{
  const auto& p = mesh.points;
  if (orientation(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) < 0)
  {
    std::swap(t[0], t[1]);
  }
  mesh.tetrahedra.push_back(t);
}

// Two pyramids over a square of which one is cut along one diagonal, the other along the other; between the two
// cuts lies a tetrahedron of the given height.
MeshData octahedron(double height)
{
  MeshData mesh;
  mesh.points = { { 0, 0, 0 }, { 1, 0, height }, { 1, 1, 0 }, { 0, 1, height }, { 0.4, 0.5, 1 },
    { 0.5, 0.6, -1 } };
  add(mesh, { 0, 1, 2, 3 });
  add(mesh, { 0, 1, 3, 4 });
  add(mesh, { 1, 2, 3, 4 });
  add(mesh, { 0, 1, 2, 5 });
  add(mesh, { 0, 2, 3, 5 });
  for (Index i = 0; i < 4; ++i)
  {
    const Index next = (i + 1) % 4;
    mesh.triangles.push_back({ i, next, 4 });
    mesh.triangles.push_back({ next, i, 5 });
  }
  mesh.trianglePatch.assign(mesh.triangles.size(), 1);
  return mesh;
}

const PatchTable Patches = { {}, { "body", PatchType::Wall } };
} // namespace

TEST(FlatTetrahedra, AreSwappedAway)
{
  MeshData mesh = octahedron(1e-15);
  ASSERT_TRUE(findFaults(mesh).none()) << findFaults(mesh).text();
  EXPECT_EQ(countFlatTetrahedra(mesh), 1U);
  EXPECT_EQ(swapFlatTetrahedra(Patches, mesh), 0U);
  EXPECT_EQ(countFlatTetrahedra(mesh), 0U);
  EXPECT_EQ(mesh.tetrahedra.size(), 4U);
  EXPECT_EQ(mesh.triangles.size(), 8U);
  EXPECT_TRUE(findFaults(mesh).none()) << findFaults(mesh).text();
}

TEST(FlatTetrahedra, OthersStay)
{
  MeshData mesh = octahedron(1e-3);
  const MeshData before = mesh;
  EXPECT_EQ(swapFlatTetrahedra(Patches, mesh), 0U);
  EXPECT_EQ(mesh.tetrahedra, before.tetrahedra);
}

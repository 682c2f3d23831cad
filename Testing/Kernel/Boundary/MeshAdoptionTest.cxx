#include "Boundary/MeshAdoption.h"

#include "Mesh/Validation.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace
{
using namespace ransmesh;

void expectAdopted(MeshData mesh, PatchTable table, std::size_t patches, std::size_t remarksWanted)
{
  const double volume = totalVolume(mesh);
  std::vector<std::string> remarks;
  NamedRegions regions;
  const Outcome outcome = adoptMesh(mesh, regions, table, 30, remarks);
  EXPECT_TRUE(outcome.ok()) << outcome.message;
  EXPECT_TRUE(findFaults(mesh).none()) << findFaults(mesh).text();
  EXPECT_NEAR(totalVolume(mesh), std::fabs(volume), 1e-12);
  EXPECT_EQ(std::set<int>(mesh.trianglePatch.begin(), mesh.trianglePatch.end()).size(), patches);
  EXPECT_EQ(remarks.size(), remarksWanted);
  EXPECT_TRUE(std::is_sorted(mesh.trianglePatch.begin(), mesh.trianglePatch.end()));
}

const PatchTable Sides = grid_mesh::patches(PatchType::Wall);

TEST(MeshAdoption, LeavesAGoodMeshAsItIs)
{
  expectAdopted(grid_mesh::make({ 3, 3, 3 }), Sides, 6, 0);
}

TEST(MeshAdoption, TurnsTetrahedraAndTriangles)
{
  MeshData mesh = grid_mesh::make({ 3, 3, 3 });
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); t += 2)
  {
    std::swap(mesh.tetrahedra[t][0], mesh.tetrahedra[t][1]);
  }
  for (auto& triangle : mesh.triangles)
  {
    std::swap(triangle[0], triangle[1]);
  }
  std::vector<std::string> remarks;
  PatchTable table = Sides;
  NamedRegions regions;
  ASSERT_TRUE(adoptMesh(mesh, regions, table, 30, remarks).ok());
  EXPECT_NEAR(totalVolume(mesh), 1, 1e-12);
  EXPECT_EQ(remarks.size(), 1u);
}

TEST(MeshAdoption, GivesPatchesByAngle)
{
  MeshData mesh = grid_mesh::make({ 3, 3, 3 });
  mesh.triangles.clear();
  mesh.trianglePatch.clear();
  expectAdopted(mesh, { { "fluid", PatchType::Patch } }, 6, 1);
}

TEST(MeshAdoption, CompletesWhatIsMissing)
{
  MeshData mesh = grid_mesh::make({ 3, 3, 3 });
  mesh.trianglePatch[0] = 0;                   // unknown
  mesh.triangles.push_back({ 0, 1, 63 });      // no face
  mesh.triangles.push_back(mesh.triangles[5]); // repeated
  mesh.trianglePatch.insert(mesh.trianglePatch.end(), { 1, 2 });
  expectAdopted(mesh, Sides, 7, 3);
}

TEST(MeshAdoption, MergesPointsAndDropsUnusedOnes)
{
  MeshData mesh = grid_mesh::make({ 3, 3, 3 });
  const auto count = static_cast<Index>(mesh.points.size());
  mesh.points.push_back(mesh.points[mesh.triangles[0][0]]);
  mesh.triangles[0][0] = count;
  mesh.points.push_back({ 9, 9, 9 });
  expectAdopted(mesh, Sides, 6, 1);
}

TEST(MeshAdoption, KeepsSheets)
{
  MeshData mesh = grid_mesh::make({ 4, 4, 4 });
  grid_mesh::addSheet(mesh, [](const Vector3& m) { return m.x == 0.5 && m.y < 0.6; });
  PatchTable table = grid_mesh::patches(PatchType::Wall, 7);
  expectAdopted(mesh, table, 7, 0);
  for (int& patch : mesh.trianglePatch)
  {
    patch = 1;
  }
  expectAdopted(mesh, table, 2, 1); // the inner part has a patch of its own
}

TEST(MeshAdoption, DividesRegions)
{
  MeshData mesh = grid_mesh::make({ 4, 4, 4 });
  NamedRegions regions;
  for (const auto& tet : mesh.tetrahedra)
  {
    const bool isLow =
      std::all_of(tet.begin(), tet.end(), [&mesh](Index v) { return mesh.points[v].x <= 0.5; });
    regions.of.push_back(isLow ? 7 : 3);
  }
  regions.name = { { 7, "solid" } };
  const std::vector<int> before = regions.of;
  PatchTable table = Sides;
  std::vector<std::string> remarks;
  ASSERT_TRUE(adoptMesh(mesh, regions, table, 30, remarks).ok());
  EXPECT_EQ(regions.of, before);
  EXPECT_EQ(remarks.size(), 1u);
  EXPECT_EQ(table.back().name, "region_3_to_solid");
  EXPECT_EQ(table.back().type, PatchType::Interface);
  EXPECT_EQ(
    std::count(mesh.trianglePatch.begin(), mesh.trianglePatch.end(), static_cast<int>(table.size()) - 1), 32);
  regions = {};
  ASSERT_TRUE(adoptMesh(mesh, regions, table, 30, remarks).ok()); // by the triangles now
  EXPECT_EQ(std::set<int>(regions.of.begin(), regions.of.end()), (std::set<int>{ 1, 2 }));
}

TEST(MeshAdoption, RefusesWhatCannotBeAMesh)
{
  const auto refused = [](const MeshData& mesh)
  {
    MeshData copy = mesh;
    PatchTable table = Sides;
    NamedRegions regions;
    std::vector<std::string> remarks;
    return adoptMesh(copy, regions, table, 30, remarks).message;
  };
  EXPECT_NE(refused({}).find("no tetrahedra"), std::string::npos);
  MeshData mesh = grid_mesh::make({ 2, 2, 2 });
  mesh.points[0].x = std::nan("");
  EXPECT_NE(refused(mesh).find("not finite"), std::string::npos);
  mesh = grid_mesh::make({ 2, 2, 2 });
  mesh.tetrahedra[0][0] = 1000;
  EXPECT_NE(refused(mesh).find("points that are not there"), std::string::npos);
  mesh = grid_mesh::make({ 2, 2, 2 });
  mesh.points[mesh.tetrahedra[0][0]] = mesh.points[mesh.tetrahedra[0][1]];
  EXPECT_NE(refused(mesh).find("no volume"), std::string::npos);
  mesh = grid_mesh::make({ 2, 2, 2 });
  mesh.tetrahedra.push_back(mesh.tetrahedra[0]);
  EXPECT_NE(refused(mesh).find("not valid"), std::string::npos);
}
} // namespace

// Insides of bodies that vtkIsotropicTetMesher meshes, too.
#include "MesherRun.h"
#include "TestSurfaces.h"

#include "Mesh/Regions.h"
#include "Support/DataContract.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"

#include <cmath>
#include <numbers>

namespace
{
// The volumes of the regions, the smallest first.
std::vector<double> volumesOf(const ransmesh::MeshData& mesh)
{
  std::vector<double> volumes;
  const std::vector<int> regions = ransmesh::numberRegions(mesh);
  for (std::size_t t = 0; t < regions.size(); ++t)
  {
    volumes.resize(std::max<std::size_t>(volumes.size(), regions[t]), 0);
    const auto& v = mesh.tetrahedra[t];
    const auto& p = mesh.points;
    volumes[regions[t] - 1] +=
      std::fabs(dot(cross(p[v[1]] - p[v[0]], p[v[2]] - p[v[0]]), p[v[3]] - p[v[0]])) / 6;
  }
  std::sort(volumes.begin(), volumes.end());
  return volumes;
}

double ballVolume(double radius)
{
  return 4 * std::numbers::pi / 3 * radius * radius * radius;
}

void addNestedBalls(vtkIsotropicTetMesher* mesher)
{
  mesher->AddInputDataObject(TestSurfaces::Sphere(0.5, 24));  // surface_1
  mesher->AddInputDataObject(TestSurfaces::Sphere(0.25, 16)); // surface_2
  mesher->FarFieldOn();
  mesher->SetFarFieldMargins(1, 1, 1, 1, 1, 1);
}
} // namespace

TEST(MesherInsides, BecomeRegionsOfTheirOwn)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  addNestedBalls(mesher);
  mesher->KeepInside("surface_*");
  const MesherRun run(mesher);
  const std::vector<double> volumes = volumesOf(run.mesh);
  ASSERT_EQ(volumes.size(), 3u);
  EXPECT_NEAR(volumes[0], ballVolume(0.25), 0.06 * ballVolume(0.25)); // of triangles, so a little less
  EXPECT_NEAR(volumes[1], ballVolume(0.5) - ballVolume(0.25), 0.06 * ballVolume(0.5));
  EXPECT_NEAR(volumes[0] + volumes[1] + volumes[2], 27, 0.1);
  EXPECT_EQ(run.typeOf.at("surface_1"), ransmesh::PatchType::Patch);
  double range[2];
  mesher->GetOutput()->GetCellData()->GetArray(ransmesh::contract::RegionId)->GetRange(range);
  EXPECT_EQ(range[1], 3);
}

TEST(MesherInsides, HoldBodiesThatStayEmpty)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  addNestedBalls(mesher);
  mesher->KeepInside("surface_1");
  const MesherRun run(mesher);
  EXPECT_EQ(volumesOf(run.mesh).size(), 2u);
  EXPECT_NEAR(ransmesh::totalVolume(run.mesh), 27 - ballVolume(0.25), 0.1);
  EXPECT_EQ(run.typeOf.at("surface_2"), ransmesh::PatchType::Wall);
}

TEST(MesherInsides, AreCutByPlanes)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  addNestedBalls(mesher);
  mesher->KeepInside("surface_?");
  mesher->SetPatchType("surface_2", "wall");
  mesher->SetSymmetryPlane(vtkIsotropicTetMesher::ACROSS_Y);
  const MesherRun run(mesher);
  const std::vector<double> volumes = volumesOf(run.mesh);
  ASSERT_EQ(volumes.size(), 3u);
  EXPECT_NEAR(volumes[0], ballVolume(0.25) / 2, 0.06 * ballVolume(0.25));
  EXPECT_EQ(run.typeOf.at("surface_2"), ransmesh::PatchType::Wall);
}

TEST(MesherInsides, NameMissingPatches)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  ErrorCatcher errors(mesher);
  addNestedBalls(mesher);
  mesher->KeepInside("core");
  mesher->Update();
  EXPECT_NE(errors.GetText().find("no patch is named 'core' (KeepInside); there are: surface_1, surface_2"),
    std::string::npos)
    << errors.GetText();
  mesher->ClearKeptInsides();
  mesher->Update();
  EXPECT_GT(mesher->GetOutput()->GetNumberOfCells(), 0);
}

// What vtkIsotropicTetMesher makes of sound surfaces.
#include "MesherRun.h"
#include "TestSurfaces.h"

#include "Support/DataContract.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkStringArray.h"

TEST(IsotropicTetMesher, FillsACube)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(TestSurfaces::Cube(0, 1));
  mesher->SetMaximumEdgeLength(0.2);
  const MesherRun run(mesher);
  EXPECT_NEAR(ransmesh::totalVolume(run.mesh), 1, 1e-12);
  EXPECT_EQ(run.trianglesOf.size(), 1u);
  EXPECT_TRUE(run.trianglesOf.contains("surface"));
  // The size that was asked for holds: a volume of edges 0.2 has about 1 / (0.2^3 / 8.5) tetrahedra.
  EXPECT_GT(run.mesh.tetrahedra.size(), 500u);
  EXPECT_LT(run.mesh.tetrahedra.size(), 4000u);
  const auto* switches = vtkStringArray::SafeDownCast(
    mesher->GetOutput()->GetFieldData()->GetAbstractArray(ransmesh::contract::MesherSwitches));
  ASSERT_TRUE(switches);
  ASSERT_EQ(switches->GetNumberOfValues(), 1);
  EXPECT_EQ(switches->GetValue(0).find("pq"), 0u) << switches->GetValue(0);
}

TEST(IsotropicTetMesher, TakesPolygonsAndKeepsTheSurface)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  const auto sphere = TestSurfaces::Sphere(1, 16);
  mesher->AddInputDataObject(sphere);
  const MesherRun run(mesher);
  EXPECT_EQ(static_cast<vtkIdType>(run.mesh.triangles.size()), sphere->GetNumberOfCells());
}

TEST(IsotropicTetMesher, LeavesBodiesInADomainEmpty)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(TestSurfaces::Cube(-4, 4));
  mesher->AddInputDataObject(TestSurfaces::Cube(-0.5, 0.5));
  mesher->AddInputDataObject(TestSurfaces::Sphere(0.5, 12, 2));
  const MesherRun run(mesher);
  EXPECT_EQ(run.trianglesOf.at("surface_2"), 12);
  EXPECT_LT(ransmesh::totalVolume(run.mesh), 512 - 1 - 0.4);
  EXPECT_GT(ransmesh::totalVolume(run.mesh), 512 - 1 - 0.6);
}

TEST(IsotropicTetMesher, PutsABoxAroundBodies)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(TestSurfaces::Sphere(1, 24));
  mesher->FarFieldOn();
  mesher->SetFarFieldMargins(2, 4, 1, 1, 1, 1.5);
  const MesherRun run(mesher);
  double bounds[6];
  mesher->GetOutput()->GetBounds(bounds);
  const double expected[6] = { -5, 9, -3, 3, -3, 4 };
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(bounds[i], expected[i], 0.05);
  }
  EXPECT_EQ(run.typeOf.at("surface"), ransmesh::PatchType::Wall);
  EXPECT_EQ(run.typeOf.at("farfield_xmin"), ransmesh::PatchType::FarField);
  EXPECT_EQ(run.trianglesOf.size(), 7u);
  EXPECT_GT(run.trianglesOf.at("farfield_zmax"), 8) << "the box's sides are refined";
}

TEST(IsotropicTetMesher, FindsTheInsideOfAHollowShell)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(TestSurfaces::Cup(0.02));
  mesher->SetMaximumEdgeLength(2);
  mesher->AddRefinementBox(0, 1, 0, 1, 0, 2, 0.15);
  mesher->FarFieldOn();
  mesher->SetFarFieldMargins(1, 1, 1, 1, 1, 1);
  const MesherRun run(mesher);
  const double solid = 2 - 0.96 * 0.96 * 1.98;
  EXPECT_NEAR(ransmesh::totalVolume(run.mesh), 5 * 5 * 6 - solid, 1e-9);
}

TEST(IsotropicTetMesher, LeavesOutWhatLiesInsideABody)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(TestSurfaces::Sphere(1, 16));
  mesher->AddInputDataObject(TestSurfaces::Sphere(0.5, 12));
  mesher->FarFieldOn();
  const MesherRun run(mesher);
  EXPECT_TRUE(run.trianglesOf.contains("surface_1"));
  EXPECT_FALSE(run.trianglesOf.contains("surface_2"));
}

TEST(IsotropicTetMesher, RefinesBoxesAndSpheres)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(TestSurfaces::Cube(0, 1));
  mesher->SetMaximumEdgeLength(0.5);
  const std::size_t coarse = MesherRun(mesher).mesh.tetrahedra.size();
  mesher->AddRefinementSphere(0.5, 0.5, 0.5, 0.1, 0.04);
  const std::size_t fine = MesherRun(mesher).mesh.tetrahedra.size();
  EXPECT_GT(fine, 3 * coarse);
  mesher->ClearRefinements();
  EXPECT_EQ(MesherRun(mesher).mesh.tetrahedra.size(), coarse);
}

TEST(IsotropicTetMesher, GivesTheSameMeshTwice)
{
  const auto mesh = []
  {
    vtkNew<vtkIsotropicTetMesher> mesher;
    mesher->AddInputDataObject(TestSurfaces::Sphere(1, 20));
    mesher->FarFieldOn();
    return MesherRun(mesher).mesh;
  };
  const ransmesh::MeshData first = mesh();
  const ransmesh::MeshData second = mesh();
  EXPECT_EQ(first.points, second.points);
  EXPECT_EQ(first.tetrahedra, second.tetrahedra);
  EXPECT_EQ(first.triangles, second.triangles);
}

TEST(IsotropicTetMesher, GrowsSizesAwayFromTheSurface)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(TestSurfaces::Sphere(1, 40));
  mesher->FarFieldOn();
  const std::size_t usual = MesherRun(mesher).mesh.tetrahedra.size();
  mesher->SetSurfaceGrowthRate(1.1);
  EXPECT_GT(MesherRun(mesher).mesh.tetrahedra.size(), 2 * usual);
}

TEST(IsotropicTetMesher, WorksAtAnyScaleAndPlace)
{
  for (const auto& [scale, shift] : { std::pair{ 1e-9, 0.0 }, { 1e9, 0.0 }, { 1.0, 1e6 }, { 1e-3, 10.0 } })
  {
    const auto sphere = TestSurfaces::Sphere(1, 24);
    for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
    {
      double x[3];
      sphere->GetPoint(i, x);
      sphere->GetPoints()->SetPoint(i, scale * x[0] + shift, scale * x[1] - shift, scale * x[2] + shift);
    }
    vtkNew<vtkIsotropicTetMesher> mesher;
    mesher->AddInputDataObject(sphere);
    mesher->FarFieldOn();
    const MesherRun run(mesher);
    EXPECT_GT(run.mesh.tetrahedra.size(), 2000u) << scale << " " << shift;
  }
}

TEST(IsotropicTetMesher, TakesBodiesThatTouchAtAnEdgeOrAPoint)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(TestSurfaces::Cube(0, 1));
  mesher->AddInputDataObject(TestSurfaces::Cube(1, 2)); // shares the corner (1, 1, 1)
  mesher->FarFieldOn();
  const MesherRun run(mesher);
  EXPECT_EQ(run.trianglesOf.at("surface_1"), 12);
  EXPECT_EQ(run.trianglesOf.at("surface_2"), 12);
}

TEST(IsotropicTetMesher, MeshesDomainsApart)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(TestSurfaces::Cube(0, 1));
  mesher->AddInputDataObject(TestSurfaces::Cube(3, 5));
  const MesherRun run(mesher);
  EXPECT_NEAR(ransmesh::totalVolume(run.mesh), 1 + 8, 1e-9);
  auto* regions = mesher->GetOutput()->GetCellData()->GetArray(ransmesh::contract::RegionId);
  ASSERT_TRUE(regions);
  double range[2];
  regions->GetRange(range);
  EXPECT_EQ(range[0], 0);
  EXPECT_EQ(range[1], 2);
}

TEST(IsotropicTetMesher, RemeshesSurfacesAndKeepsTheirEdgesAndPatches)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(TestSurfaces::Cup(0.1));
  mesher->PatchFromFeatureAngleOn();
  mesher->SetSurfaceEdgeLength(0.08);
  const MesherRun run(mesher);
  EXPECT_EQ(run.trianglesOf.size(), 11u);
  EXPECT_GT(run.mesh.triangles.size(), 1500u);
  EXPECT_NEAR(ransmesh::totalVolume(run.mesh), 2 - 0.8 * 0.8 * 1.9, 1e-9);
}

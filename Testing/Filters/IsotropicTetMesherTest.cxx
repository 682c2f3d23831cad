// What vtkIsotropicTetMesher makes of sound surfaces.
#include "ErrorCatcher.h"
#include "TestSurfaces.h"

#include "MeshConversion.h"
#include "vtkIsotropicTetMesher.h"

#include "Boundary/SurfaceTriangles.h"
#include "Mesh/Validation.h"
#include "Support/DataContract.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

namespace
{
// Runs the mesher and reads its mesh back; the test fails where the mesh is not valid.
struct MesherRun
{
  ransmesh::MeshData mesh;
  ransmesh::PatchTable patches;
  std::map<std::string, int> trianglesOf;
  std::map<std::string, ransmesh::PatchType> typeOf;

  explicit MesherRun(vtkIsotropicTetMesher* mesher)
  {
    ErrorCatcher errors(mesher);
    mesher->Update();
    EXPECT_EQ(errors.GetText(), "");
    const ransmesh::Outcome outcome = ransmesh::readMesh(mesher->GetOutput(), mesh, patches);
    EXPECT_TRUE(outcome.ok()) << outcome.message;
    const ransmesh::MeshFaults faults = ransmesh::findFaults(mesh);
    EXPECT_TRUE(faults.none()) << faults.text();
    for (const int patch : mesh.trianglePatch)
    {
      ++trianglesOf[patches.at(patch).name];
    }
    for (std::size_t i = 1; i < patches.size(); ++i)
    {
      typeOf[patches[i].name] = patches[i].type;
    }
    EXPECT_TRUE(std::is_sorted(mesh.trianglePatch.begin(), mesh.trianglePatch.end()));
  }
};
} // namespace

namespace
{
// A flat box whose top and bottom are two fans of needles each; all one patch. Bent along y by `bend`.
vtkSmartPointer<vtkPolyData> boxOfNeedles(double bend = 0)
{
  constexpr vtkIdType n = 8;
  constexpr double width = 0.1;
  std::vector<std::array<double, 3>> points;
  for (const double z : { 0.0, 0.1 })
  {
    for (int row = 0; row < 2; ++row)
    {
      for (vtkIdType i = 0; i <= n; ++i)
      {
        const double x = static_cast<double>(i) / n;
        points.push_back({ x, row * width, z - bend * x * x });
      }
    }
  }
  const vtkIdType top = 2 * (n + 1);
  std::vector<std::array<vtkIdType, 3>> triangles;
  const auto addSide = [&](vtkIdType a, vtkIdType b)
  {
    triangles.push_back({ a, b, b + top });
    triangles.push_back({ a, b + top, a + top });
  };
  for (vtkIdType i = 0; i < n; ++i)
  {
    triangles.push_back({ i + 1, i, n + 1 });
    triangles.push_back({ n + 2 + i, n, n + 1 + i });
    triangles.push_back({ top + i, top + i + 1, top + n + 1 });
    triangles.push_back({ top + n, top + n + 2 + i, top + n + 1 + i });
    addSide(i, i + 1);
    addSide(n + 2 + i, n + 1 + i);
  }
  addSide(n, 2 * n + 1);
  addSide(n + 1, 0);
  return TestSurfaces::Triangles(points, triangles);
}

vtkIdType numberOfSwaps(vtkIsotropicTetMesher* mesher)
{
  vtkFieldData* data = mesher->GetOutput()->GetFieldData();
  auto* swaps = vtkIdTypeArray::SafeDownCast(data->GetAbstractArray(ransmesh::contract::SurfaceSwaps));
  return swaps ? swaps->GetValue(0) : -1;
}

double largestAngleOf(const MesherRun& run)
{
  double largest = 0;
  const ransmesh::SurfaceMesh surface = { run.mesh.points, run.mesh.triangles, run.mesh.trianglePatch };
  for (const auto& triangle : surface.triangles)
  {
    largest = std::fmax(largest, ransmesh::largestAngle(surface, triangle));
  }
  return largest;
}
} // namespace

TEST(IsotropicTetMesher, SwapsDiagonalsOfFlatTriangles)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(boxOfNeedles());
  const MesherRun run(mesher);
  EXPECT_GT(numberOfSwaps(mesher), 10);
  EXPECT_LT(largestAngleOf(run), 150);
  EXPECT_NEAR(ransmesh::totalVolume(run.mesh), 0.01, 1e-15);
}

TEST(IsotropicTetMesher, SplitsFlatTrianglesAgainstRidges)
{
  // A thin bar; the bottom has a point on one long edge only.
  const auto bar =
    TestSurfaces::Triangles({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0.01, 0 }, { 0.4, 0.01, 0 }, { 0, 0.01, 0 },
                              { 0, 0, 0.1 }, { 1, 0, 0.1 }, { 1, 0.01, 0.1 }, { 0, 0.01, 0.1 } },
      { { 0, 3, 1 }, { 1, 3, 2 }, { 0, 4, 3 }, { 5, 6, 7 }, { 5, 7, 8 }, { 0, 1, 6 }, { 0, 6, 5 },
        { 2, 3, 7 }, { 3, 8, 7 }, { 3, 4, 8 }, { 1, 2, 7 }, { 1, 7, 6 }, { 4, 0, 5 }, { 4, 5, 8 } });
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(bar);
  const MesherRun run(mesher);
  const auto* splits = vtkIdTypeArray::SafeDownCast(
    mesher->GetOutput()->GetFieldData()->GetAbstractArray(ransmesh::contract::SurfaceSplits));
  ASSERT_TRUE(splits);
  EXPECT_GT(splits->GetValue(0), 0);
  EXPECT_LE(largestAngleOf(run), 175);
  EXPECT_NEAR(ransmesh::totalVolume(run.mesh), 0.001, 1e-15);
}

TEST(IsotropicTetMesher, KeepsFlatTrianglesOnDemand)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(boxOfNeedles());
  mesher->ImproveSurfaceTrianglesOff();
  const MesherRun run(mesher);
  EXPECT_EQ(numberOfSwaps(mesher), 0);
  EXPECT_GT(largestAngleOf(run), 173);
}

TEST(IsotropicTetMesher, SwapsNoDiagonalsOfInterfaces)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(boxOfNeedles());
  mesher->SetPatchType("*", "interface");
  const MesherRun run(mesher);
  EXPECT_EQ(numberOfSwaps(mesher), 0);
}

TEST(IsotropicTetMesher, SwapsAsFarAsTheSurfaceMayTurn)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(boxOfNeedles(0.004));
  mesher->SetMaximumSurfaceAngle(0.01);
  const MesherRun narrow(mesher);
  EXPECT_EQ(numberOfSwaps(mesher), 0);
  mesher->SetMaximumSurfaceAngle(10);
  const MesherRun wide(mesher);
  EXPECT_GT(numberOfSwaps(mesher), 10);
  EXPECT_NEAR(ransmesh::totalVolume(wide.mesh), ransmesh::totalVolume(narrow.mesh), 1e-5);
}

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

TEST(IsotropicTetMesher, NamesPatchesByBlocks)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, TestSurfaces::Cube(-4, 4));
  blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "FarField");
  blocks->SetBlock(1, TestSurfaces::Sphere(1, 12));
  blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "hull");
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(blocks);
  mesher->SetPatchType("hu*", "wall");
  const MesherRun run(mesher);
  EXPECT_EQ(run.trianglesOf.size(), 2u);
  EXPECT_EQ(run.typeOf.at("FarField"), ransmesh::PatchType::FarField);
  EXPECT_EQ(run.typeOf.at("hull"), ransmesh::PatchType::Wall);
}

TEST(IsotropicTetMesher, TakesCollectionsOfPartitions)
{
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartition(0, 0, TestSurfaces::Sphere(1, 12));
  collection->SetPartition(0, 1, TestSurfaces::Sphere(1, 12, 3));
  collection->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "balls");
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(collection);
  mesher->FarFieldOn();
  const MesherRun run(mesher);
  EXPECT_EQ(run.trianglesOf.count("balls"), 1u);
  EXPECT_EQ(run.trianglesOf.size(), 7u);
}

TEST(IsotropicTetMesher, KeepsPatchNumbersAndNames)
{
  const auto cube = TestSurfaces::Cube(0, 1);
  vtkNew<vtkIntArray> patch;
  patch->SetName(ransmesh::contract::PatchId);
  for (int i = 0; i < 12; ++i)
  {
    patch->InsertNextValue(i < 6 ? 2 : 4);
  }
  cube->GetCellData()->AddArray(patch);
  vtkNew<vtkStringArray> names;
  names->SetName(ransmesh::contract::PatchNames);
  for (const char* name : { "fluid", "a", "sym_left", "b", "nose" })
  {
    names->InsertNextValue(name);
  }
  cube->GetFieldData()->AddArray(names);
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(cube);
  const MesherRun run(mesher);
  EXPECT_EQ(run.patches.at(2).name, "sym_left");
  EXPECT_EQ(run.patches.at(2).type, ransmesh::PatchType::Symmetry);
  EXPECT_EQ(run.patches.at(4).name, "nose");
  EXPECT_EQ(run.trianglesOf.at("nose"), 6);
}

TEST(IsotropicTetMesher, ReadsTheNumbersOfOtherTools)
{
  const auto cube = TestSurfaces::Cube(0, 1);
  vtkNew<vtkDoubleArray> groups;
  groups->SetName("GroupIds");
  for (int i = 0; i < 12; ++i)
  {
    groups->InsertNextValue(i / 4);
  }
  cube->GetCellData()->AddArray(groups);
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(cube);
  const MesherRun run(mesher);
  EXPECT_EQ(run.trianglesOf.size(), 3u);
  EXPECT_EQ(run.trianglesOf.at("patch_0"), 4);
}

TEST(IsotropicTetMesher, SplitsPatchesAtEdges)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(TestSurfaces::Cube(0, 1));
  mesher->PatchFromFeatureAngleOn();
  const MesherRun run(mesher);
  EXPECT_EQ(run.trianglesOf.size(), 6u);
  EXPECT_EQ(run.trianglesOf.at("surface_6"), 2);
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

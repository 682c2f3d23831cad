// What vtkIsotropicTetMesher does about very obtuse surface triangles.
#include "MesherRun.h"
#include "TestSurfaces.h"

#include "Support/DataContract.h"
#include "Triangles/SurfaceTriangles.h"

#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"

#include <cmath>

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

#include "MesherRun.h"
#include "TestSurfaces.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <functional>

namespace
{
using ransmesh::Vector3;

// Mean and largest edge of the tetrahedra whose middle is taken.
struct Edges
{
  double mean = 0;
  double largest = 0;
};

Edges edgesWhere(const MesherRun& run, const std::function<bool(const Vector3&)>& takes)
{
  Edges edges;
  int count = 0;
  for (const auto& t : run.mesh.tetrahedra)
  {
    const auto& p = run.mesh.points;
    if (!takes(0.25 * (p[t[0]] + p[t[1]] + p[t[2]] + p[t[3]])))
    {
      continue;
    }
    for (int i = 0; i < 4; ++i)
    {
      for (int k = i + 1; k < 4; ++k, ++count)
      {
        const double length = distance(p[t[i]], p[t[k]]);
        edges.mean += length;
        edges.largest = std::max(edges.largest, length);
      }
    }
  }
  EXPECT_GT(count, 0);
  edges.mean /= std::max(1, count);
  return edges;
}

// That edges are of the size: TetGen makes none much longer, and its mean lies somewhat below.
void expectSize(const Edges& edges, double size)
{
  EXPECT_LT(edges.largest, 2 * size);
  EXPECT_GT(edges.mean, 0.4 * size);
  EXPECT_LT(edges.mean, 1.2 * size);
}
} // namespace

TEST(IsotropicTetMesherSizes, HoldInABoxASphereAndAroundALine)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(TestSurfaces::Cube(0, 4));
  mesher->SetMaximumEdgeLength(1);
  mesher->AddRefinementBox(0.5, 1, 0.5, 1, 0.5, 1, 0.15);
  mesher->AddRefinementSphere(3, 3, 3, 0.4, 0.2);
  mesher->AddRefinementLine(3, 1, 0.8, 3, 1, 3.2, 0.2, 0.15);
  const MesherRun run(mesher);
  expectSize(edgesWhere(run,
               [](const Vector3& x) {
                 return std::min({ x.x, x.y, x.z }) > 0.5 && std::max({ x.x, x.y, x.z }) < 1;
               }),
    0.15);
  expectSize(edgesWhere(run, [](const Vector3& x) { return distance(x, { 3, 3, 3 }) < 0.4; }), 0.2);
  expectSize(edgesWhere(run,
               [](const Vector3& x) { return x.z > 0.8 && x.z < 3.2 && std::hypot(x.x - 3, x.y - 1) < 0.2; }),
    0.15);
  expectSize(edgesWhere(run, [](const Vector3& x) { return distance(x, { 1, 3, 2 }) < 0.7; }), 1);
}

TEST(IsotropicTetMesherSizes, GrowAwayFromTheSurface)
{
  const auto meanAt = [](double growth)
  {
    vtkNew<vtkIsotropicTetMesher> mesher;
    mesher->AddInputDataObject(TestSurfaces::Sphere(0.5, 24));
    mesher->FarFieldOn();
    mesher->SetFarFieldMargins(4, 4, 4, 4, 4, 4);
    mesher->SetSurfaceGrowthRate(growth);
    const MesherRun run(mesher);
    return edgesWhere(run, [](const Vector3& x) { return std::fabs(norm(x) - 2) < 0.3; }).mean;
  };
  const double slow = meanAt(1.15);
  const double fast = meanAt(1.5);
  EXPECT_LT(slow, 0.13 + 0.15 * 1.8);
  EXPECT_GT(fast, 1.5 * slow);
}

TEST(IsotropicTetMesherSizes, FollowAnArrayOnTheSurface)
{
  vtkSmartPointer<vtkPolyData> cube = TestSurfaces::Cube(0, 1);
  vtkNew<vtkDoubleArray> sizes;
  sizes->SetName("Wanted");
  for (vtkIdType i = 0; i < cube->GetNumberOfPoints(); ++i)
  {
    sizes->InsertNextValue(cube->GetPoint(i)[2] == 0 ? 0.06 : 0.25);
  }
  cube->GetPointData()->AddArray(sizes);
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(cube);
  mesher->SetSurfaceSizeArray("Wanted");
  const MesherRun run(mesher);
  expectSize(edgesWhere(run, [](const Vector3& x) { return x.z < 0.03; }), 0.06);
  EXPECT_GT(edgesWhere(run, [](const Vector3& x) { return x.z > 0.9; }).mean, 0.12);
}

TEST(IsotropicTetMesherSizes, ArePerPatch)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(TestSurfaces::Cube(0, 1));
  mesher->AddInputDataObject(TestSurfaces::Cube(2, 3));
  mesher->SetPatchEdgeLength("surface_2", 0.1);
  mesher->FarFieldOn();
  MesherRun run(mesher);
  EXPECT_EQ(run.trianglesOf["surface_1"], 12);
  EXPECT_NEAR(run.trianglesOf["surface_2"], 6 / (0.433 * 0.01), 500);
}

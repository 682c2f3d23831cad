#include "ErrorCatcher.h"
#include "TestSurfaces.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSurfaceRemesher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace
{
using Place = std::array<double, 3>;

struct Triangle
{
  std::array<Place, 3> corners;
  int patch = 0;

  double edge(int i) const
  {
    return std::sqrt(vtkMath::Distance2BetweenPoints(corners[i].data(), corners[(i + 1) % 3].data()));
  }
  double smallestAngle() const
  {
    double least = 180;
    for (int i = 0; i < 3; ++i)
    {
      const double a = edge(i);
      const double b = edge((i + 1) % 3);
      const double c = edge((i + 2) % 3);
      const double cosine = (a * a + b * b - c * c) / (2 * a * b);
      least = std::min(least, vtkMath::DegreesFromRadians(std::acos(std::clamp(cosine, -1.0, 1.0))));
    }
    return least;
  }
};

std::vector<Triangle> trianglesOf(vtkPolyData* surface)
{
  std::vector<Triangle> triangles;
  vtkDataArray* patch = surface->GetCellData()->GetArray("PatchId");
  for (vtkIdType t = 0; t < surface->GetNumberOfCells(); ++t)
  {
    Triangle triangle;
    for (int i = 0; i < 3; ++i)
    {
      surface->GetPoint(surface->GetCell(t)->GetPointId(i), triangle.corners[i].data());
    }
    triangle.patch = static_cast<int>(patch->GetTuple1(t));
    triangles.push_back(triangle);
  }
  return triangles;
}

std::vector<Triangle> run(vtkSurfaceRemesher* remesher)
{
  ErrorCatcher errors(remesher);
  remesher->Update();
  EXPECT_EQ(errors.GetText(), "");
  return trianglesOf(remesher->GetOutput());
}

// The mean edge of the triangles whose first corner is taken.
double meanEdge(const std::vector<Triangle>& triangles, const std::function<bool(const Triangle&)>& takes)
{
  double sum = 0;
  int count = 0;
  for (const Triangle& t : triangles)
  {
    for (int i = 0; takes(t) && i < 3; ++i, ++count)
    {
      sum += t.edge(i);
    }
  }
  return count > 0 ? sum / count : 0;
}

double lowAngle(const std::vector<Triangle>& triangles)
{
  std::vector<double> angles;
  for (const Triangle& t : triangles)
  {
    angles.push_back(t.smallestAngle());
  }
  std::sort(angles.begin(), angles.end());
  return angles[angles.size() / 100];
}

// A wing with a sharp trailing edge, of needles that run from tip to tip.
vtkSmartPointer<vtkPolyData> needledWing(int stations)
{
  const auto thickness = [](double x)
  {
    return 0.6 *
      (0.2969 * std::sqrt(x) - 0.126 * x - 0.3516 * x * x + 0.2843 * x * x * x - 0.1036 * x * x * x * x);
  };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const int around = 2 * stations;
  for (int i = 0; i < around; ++i)
  {
    const double x = 0.5 + 0.5 * std::cos(vtkMath::Pi() * i / stations);
    const double z = i == 0 ? 0 : (i < stations ? 1 : -1) * thickness(x);
    points->InsertNextPoint(x, -0.5, z);
    points->InsertNextPoint(x, 0.5, z);
  }
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < around; ++i)
  {
    const vtkIdType j = (i + 1) % around;
    cells->InsertNextCell({ 2 * i, 2 * i + 1, 2 * j });
    cells->InsertNextCell({ 2 * j, 2 * i + 1, 2 * j + 1 });
  }
  for (vtkIdType i = 1; i + 1 < around; ++i)
  {
    cells->InsertNextCell({ 0, 2 * i, 2 * (i + 1) });
    cells->InsertNextCell({ 1, 2 * (i + 1) + 1, 2 * i + 1 });
  }
  auto wing = vtkSmartPointer<vtkPolyData>::New();
  wing->SetPoints(points);
  wing->SetPolys(cells);
  return wing;
}
} // namespace

TEST(SurfaceRemesher, MakesGoodTrianglesOfNeedlesAndKeepsTheSharpEdge)
{
  vtkNew<vtkSurfaceRemesher> remesher;
  remesher->AddInputDataObject(needledWing(400));
  remesher->SetEdgeLength(0.08);
  remesher->SetEdgesPerCircle(24);
  const auto triangles = run(remesher);
  EXPECT_GT(lowAngle(triangles), 20);
  EXPECT_GT(remesher->GetLowAngle(), 20);
  EXPECT_LT(remesher->GetDeviation(), 1e-3);
  double sharp = 0; // each of its edges lies in two triangles
  for (const Triangle& t : triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Place& a = t.corners[i];
      const Place& b = t.corners[(i + 1) % 3];
      sharp += a[0] == 1 && b[0] == 1 && a[2] == 0 && b[2] == 0 ? t.edge(i) / 2 : 0;
    }
  }
  EXPECT_NEAR(sharp, 1, 1e-12);
}

TEST(SurfaceRemesher, MakesEdgesOfTheLengthAskedFor)
{
  vtkNew<vtkSurfaceRemesher> remesher;
  remesher->AddInputDataObject(TestSurfaces::Sphere(1, 60));
  remesher->SetEdgeLength(0.2);
  const auto all = [](const Triangle&) { return true; };
  const auto triangles = run(remesher);
  EXPECT_NEAR(meanEdge(triangles, all), 0.2, 0.04);
  EXPECT_GT(lowAngle(triangles), 30);
}

TEST(SurfaceRemesher, KeepsOtherPatchesWhereOneAloneIsNamed)
{
  vtkSmartPointer<vtkPolyData> one = TestSurfaces::Cube(0, 1);
  vtkSmartPointer<vtkPolyData> other = TestSurfaces::Cube(2, 3);
  vtkNew<vtkSurfaceRemesher> remesher;
  remesher->AddInputDataObject(one);
  remesher->AddInputDataObject(other);
  remesher->SetPatchEdgeLength("surface_2", 0.2);
  const auto triangles = run(remesher);
  const auto count = [&](int patch)
  {
    return std::count_if(
      triangles.begin(), triangles.end(), [=](const Triangle& t) { return t.patch == patch; });
  };
  EXPECT_EQ(count(1), one->GetNumberOfCells());
  EXPECT_GT(count(2), 200);
  EXPECT_NEAR(meanEdge(triangles, [](const Triangle& t) { return t.patch == 2; }), 0.2, 0.05);
}

TEST(SurfaceRemesher, MakesSmallEdgesWhereTheSurfaceIsCurved)
{
  vtkNew<vtkSurfaceRemesher> remesher;
  remesher->AddInputDataObject(TestSurfaces::Sphere(1, 80));
  remesher->SetEdgeLength(1);
  remesher->SetEdgesPerCircle(36);
  const auto triangles = run(remesher);
  const double wanted = 2 * vtkMath::Pi() / 36;
  EXPECT_NEAR(meanEdge(triangles, [](const Triangle&) { return true; }), wanted, 0.3 * wanted);
}

TEST(SurfaceRemesher, MakesSmallEdgesInGaps)
{
  vtkNew<vtkSurfaceRemesher> remesher;
  remesher->AddInputDataObject(TestSurfaces::Sphere(1, 40));
  remesher->AddInputDataObject(TestSurfaces::Sphere(1, 40, 2.1)); // 0.1 between them
  remesher->SetEdgeLength(0.3);
  remesher->SetEdgesAcrossGap(1);
  remesher->SetGapSide(1);
  const auto triangles = run(remesher);
  const auto nearGap = [](const Triangle& t) { return std::fabs(t.corners[0][0] - 1.05) < 0.06; };
  const auto far = [](const Triangle& t) { return std::fabs(t.corners[0][0] - 1.05) > 1; };
  EXPECT_LT(meanEdge(triangles, nearGap), 0.15);
  EXPECT_GT(meanEdge(triangles, far), 0.22);
}

TEST(SurfaceRemesher, FollowsAnArrayOfSizes)
{
  vtkSmartPointer<vtkPolyData> cube = TestSurfaces::Cube(0, 1);
  vtkNew<vtkDoubleArray> sizes;
  sizes->SetName("Wanted");
  for (vtkIdType i = 0; i < cube->GetNumberOfPoints(); ++i)
  {
    sizes->InsertNextValue(0.05 + 0.2 * cube->GetPoint(i)[0]);
  }
  cube->GetPointData()->AddArray(sizes);
  vtkNew<vtkSurfaceRemesher> remesher;
  remesher->AddInputDataObject(cube);
  remesher->SetEdgeLength(1);
  remesher->SetSizeArray("Wanted");
  const auto triangles = run(remesher);
  const auto side = [](double x)
  {
    return [x](const Triangle& t)
    { return t.corners[0][0] == x && t.corners[1][0] == x && t.corners[2][0] == x; };
  };
  EXPECT_NEAR(meanEdge(triangles, side(0)), 0.05, 0.015);
  EXPECT_NEAR(meanEdge(triangles, side(1)), 0.25, 0.075);
}

TEST(SurfaceRemesher, RefusesWhatItCannotDo)
{
  const auto message = [](const std::function<void(vtkSurfaceRemesher*)>& spoil)
  {
    vtkNew<vtkSurfaceRemesher> remesher;
    remesher->AddInputDataObject(TestSurfaces::Cube(0, 1));
    ErrorCatcher errors(remesher);
    spoil(remesher);
    remesher->Update();
    return errors.GetText();
  };
  const auto says = [&](const char* text, const std::function<void(vtkSurfaceRemesher*)>& spoil)
  { EXPECT_NE(message(spoil).find(text), std::string::npos) << message(spoil); };
  says("no patch is named 'keel'", [](vtkSurfaceRemesher* r) { r->SetPatchEdgeLength("keel", 1); });
  says("no surface has the point array 'Size'", [](vtkSurfaceRemesher* r) { r->SetSizeArray("Size"); });
  says("EdgeLength is -1", [](vtkSurfaceRemesher* r) { r->SetEdgeLength(-1); });
  says("a length above 0", [](vtkSurfaceRemesher* r) { r->SetPatchEdgeLength("1", 0); });
  says("more than 20 million triangles", [](vtkSurfaceRemesher* r) { r->SetEdgeLength(1e-5); });
}

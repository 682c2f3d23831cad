// Far fields, planes of symmetry, waterlines and grounds of vtkIsotropicTetMesher.
#include "MesherRun.h"
#include "TestSurfaces.h"

#include "Support/DataContract.h"

#include "vtkCellData.h"
#include "vtkClipPolyData.h"
#include "vtkIntArray.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"

#include <cmath>
#include <numbers>

namespace
{
using Mesher = vtkIsotropicTetMesher;

// How far points of a patch lie off the plane, at most.
double offPlane(const MesherRun& run, const std::string& name, int axis, double place)
{
  double most = -1; // no such patch
  for (std::size_t t = 0; t < run.mesh.triangles.size(); ++t)
  {
    if (run.patches[run.mesh.trianglePatch[t]].name == name)
    {
      for (const ransmesh::Index v : run.mesh.triangles[t])
      {
        most = std::fmax(most, std::fabs(run.mesh.points[v][axis] - place));
      }
    }
  }
  return most;
}

double areaOf(const MesherRun& run, const std::string& name)
{
  double area = 0;
  for (std::size_t t = 0; t < run.mesh.triangles.size(); ++t)
  {
    if (run.patches[run.mesh.trianglePatch[t]].name == name)
    {
      const auto& v = run.mesh.triangles[t];
      const auto& p = run.mesh.points;
      area += norm(cross(p[v[1]] - p[v[0]], p[v[2]] - p[v[0]])) / 2;
    }
  }
  return area;
}

vtkSmartPointer<vtkPolyData> ball(double x = 0)
{
  return TestSurfaces::Sphere(0.5, 24, x);
}

// A sphere of triangles has a little less than this.
constexpr double BallVolume = std::numbers::pi / 6;
} // namespace

TEST(MesherDomains, CutsAWholeBodyInHalfInItsBox)
{
  vtkNew<Mesher> mesher;
  mesher->AddInputDataObject(ball());
  mesher->FarFieldOn();
  mesher->SetFarFieldMargins(2, 2, 2, 2, 2, 2);
  mesher->SetSymmetryPlane(Mesher::ACROSS_Y);
  const MesherRun run(mesher);
  double b[6];
  mesher->GetOutput()->GetBounds(b);
  const double box = (b[1] - b[0]) * (b[3] - b[2]) * (b[5] - b[4]);
  EXPECT_NEAR(ransmesh::totalVolume(run.mesh), box - BallVolume / 2, 0.02);
  EXPECT_EQ(offPlane(run, "symmetry", 1, 0), 0);
  EXPECT_NEAR(areaOf(run, "symmetry"), (b[1] - b[0]) * (b[5] - b[4]) - std::numbers::pi / 4, 0.02);
  EXPECT_EQ(run.typeOf.at("symmetry"), ransmesh::PatchType::Symmetry);
  EXPECT_FALSE(run.typeOf.contains("farfield_ymin"));
  EXPECT_EQ(run.trianglesOf.size(), 7u);
}

TEST(MesherDomains, ClosesHalfModelsThatAreOpenInTheirPlane)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0, -1, 0);
  plane->SetOrigin(0, 1e-8, 0); // as CAD systems round
  vtkNew<vtkClipPolyData> half;
  half->SetInputData(ball());
  half->SetClipFunction(plane);
  half->Update();
  vtkNew<Mesher> mesher;
  mesher->AddInputDataObject(half->GetOutput());
  mesher->SetSymmetryPlane(Mesher::ACROSS_Y);
  const MesherRun run(mesher);
  EXPECT_NEAR(ransmesh::totalVolume(run.mesh), BallVolume / 2, 0.02);
  EXPECT_EQ(offPlane(run, "symmetry", 1, 0), 0);
  EXPECT_EQ(run.trianglesOf.size(), 2u);
}

TEST(MesherDomains, KeepsTheLargerSide)
{
  vtkNew<Mesher> mesher;
  mesher->AddInputDataObject(ball());
  mesher->SetSymmetryPlane(Mesher::ACROSS_X);
  mesher->SetSymmetryPosition(0.1);
  const MesherRun run(mesher);
  EXPECT_GT(ransmesh::totalVolume(run.mesh), 0.55 * BallVolume);
  EXPECT_EQ(offPlane(run, "symmetry", 0, 0.1), 0);
}

TEST(MesherDomains, LeavesHolesInThePlaneOfHollowBodies)
{
  vtkNew<Mesher> mesher; // between two spheres, cut in half
  mesher->AddInputDataObject(ball());
  mesher->AddInputDataObject(TestSurfaces::Sphere(0.2, 12));
  mesher->SetSymmetryPlane(Mesher::ACROSS_Z);
  const MesherRun run(mesher);
  EXPECT_NEAR(areaOf(run, "symmetry"), std::numbers::pi * (0.25 - 0.04), 0.02);
  EXPECT_NEAR(ransmesh::totalVolume(run.mesh), BallVolume / 2 * (1 - 0.064), 0.02);
}

TEST(MesherDomains, LeavesOutWhatPlanesShutOff)
{
  vtkNew<Mesher> mesher; // a hollow hull: no water is in it
  mesher->AddInputDataObject(ball());
  mesher->AddInputDataObject(TestSurfaces::Sphere(0.4, 16));
  mesher->FarFieldOn();
  mesher->SetWaterlinePlane(Mesher::ACROSS_Z);
  const MesherRun run(mesher);
  EXPECT_TRUE(run.trianglesOf.contains("surface_1"));
  EXPECT_FALSE(run.trianglesOf.contains("surface_2"));
  double b[6];
  mesher->GetOutput()->GetBounds(b);
  const double floor = (b[1] - b[0]) * (b[3] - b[2]);
  EXPECT_NEAR(areaOf(run, "waterline"), floor - std::numbers::pi / 4, 0.02);
}

TEST(MesherDomains, KeepsThePatchThatLiesInThePlane)
{
  vtkNew<Mesher> mesher; // a cube whose lowest side is a patch of its own
  const auto cube = TestSurfaces::Cube(0, 1);
  vtkNew<vtkIntArray> patch;
  patch->SetName(ransmesh::contract::PatchId);
  for (vtkIdType c = 0; c < 12; ++c)
  {
    double bounds[6];
    cube->GetCellBounds(c, bounds);
    patch->InsertNextValue(bounds[5] == 0 ? 7 : 3);
  }
  cube->GetCellData()->AddArray(patch);
  mesher->AddInputDataObject(cube);
  mesher->SetSymmetryPlane(Mesher::ACROSS_Z);
  const MesherRun run(mesher);
  EXPECT_EQ(run.trianglesOf.size(), 2u);
  EXPECT_EQ(run.typeOf.at("patch_7"), ransmesh::PatchType::Symmetry);
  EXPECT_NEAR(areaOf(run, "patch_7"), 1, 1e-12);
}

TEST(MesherDomains, CutsAShipAtItsWaterlineAndInHalf)
{
  for (const bool farField : { true, false })
  {
    vtkNew<Mesher> mesher;
    mesher->AddInputDataObject(TestSurfaces::Together({ ball(), ball(3) }));
    mesher->SetFarField(farField);
    mesher->SetSymmetryPlane(Mesher::ACROSS_Y);
    mesher->SetWaterlinePlane(Mesher::ACROSS_Z);
    mesher->SetWaterlinePosition(0.2);
    const MesherRun run(mesher);
    double bounds[6];
    mesher->GetOutput()->GetBounds(bounds);
    EXPECT_EQ(bounds[2], 0);
    EXPECT_EQ(bounds[5], 0.2);
    EXPECT_EQ(offPlane(run, "symmetry", 1, 0), 0);
    EXPECT_EQ(offPlane(run, "waterline", 2, 0.2), 0);
    EXPECT_EQ(run.typeOf.at("waterline"), ransmesh::PatchType::Symmetry);
  }
}

TEST(MesherDomains, PutsWheelsOnTheGround)
{
  vtkNew<Mesher> mesher;
  mesher->AddInputDataObject(ball());
  mesher->AddInputDataObject(ball(1.5));
  mesher->FarFieldOn();
  mesher->SetGroundPlane(Mesher::ACROSS_Z);
  mesher->SetGroundPosition(-0.47);
  const MesherRun run(mesher);
  EXPECT_EQ(offPlane(run, "ground", 2, -0.47), 0);
  EXPECT_EQ(run.typeOf.at("ground"), ransmesh::PatchType::Wall);
  double bounds[6];
  mesher->GetOutput()->GetBounds(bounds);
  EXPECT_EQ(bounds[4], -0.47);
  const double spot = std::numbers::pi * (0.25 - 0.47 * 0.47); // where a wheel stands
  const double floor = (bounds[1] - bounds[0]) * (bounds[3] - bounds[2]);
  EXPECT_NEAR(areaOf(run, "ground"), floor - 2 * spot, 0.02);
}

TEST(MesherDomains, StandsAnOffTheGroundBodyInItsBox)
{
  vtkNew<Mesher> mesher;
  mesher->AddInputDataObject(ball());
  mesher->FarFieldOn();
  mesher->SetGroundPlane(Mesher::ACROSS_Z);
  mesher->SetGroundPosition(-1);
  const MesherRun run(mesher);
  EXPECT_EQ(offPlane(run, "ground", 2, -1), 0);
}

TEST(MesherDomains, PutsASphereAroundBodies)
{
  vtkNew<Mesher> mesher;
  mesher->AddInputDataObject(ball());
  mesher->FarFieldOn();
  mesher->SetFarFieldShapeToSphere();
  mesher->SetFarFieldMargins(3, 3, 3, 3, 3, 3);
  const MesherRun run(mesher);
  const double radius = 3 + std::sqrt(0.75);
  EXPECT_NEAR(areaOf(run, "farfield") / (4 * std::numbers::pi * radius * radius), 1, 0.03);
  EXPECT_EQ(run.typeOf.at("farfield"), ransmesh::PatchType::FarField);
  EXPECT_EQ(run.typeOf.at("surface"), ransmesh::PatchType::Wall);
  mesher->SetSymmetryPlane(Mesher::ACROSS_Y);
  mesher->SetGroundPlane(Mesher::ACROSS_Z);
  mesher->SetGroundPosition(-0.4);
  const MesherRun quarter(mesher);
  EXPECT_EQ(quarter.trianglesOf.size(), 4u);
  EXPECT_EQ(offPlane(quarter, "symmetry", 1, 0), 0);
}

TEST(MesherDomains, NamesTheBoxsSides)
{
  vtkNew<Mesher> mesher;
  mesher->AddInputDataObject(ball());
  mesher->FarFieldOn();
  mesher->SetFarFieldSide("xmin", "inlet");
  mesher->SetFarFieldSide("xmax", "back", "outlet");
  mesher->SetFarFieldSide("ymin", "sides", "symmetry");
  mesher->SetFarFieldSide("ymax", "sides", "symmetry");
  mesher->SetFarFieldSide("zmax", "sky");
  const MesherRun run(mesher);
  EXPECT_EQ(run.typeOf.at("inlet"), ransmesh::PatchType::Inlet);
  EXPECT_EQ(run.typeOf.at("back"), ransmesh::PatchType::Outlet);
  EXPECT_EQ(run.typeOf.at("sides"), ransmesh::PatchType::Symmetry);
  EXPECT_EQ(run.typeOf.at("sky"), ransmesh::PatchType::FarField);
  EXPECT_EQ(run.trianglesOf.size(), 6u);
  EXPECT_NEAR(areaOf(run, "sides"), 2 * 11 * 11, 1); // the ball's own extent is a little less than 1
}

TEST(MesherDomains, SaysWhatIsWrong)
{
  const auto fails = [](const char* message, const auto& describe)
  {
    vtkNew<Mesher> mesher;
    mesher->AddInputDataObject(ball());
    describe(mesher.Get());
    ErrorCatcher errors(mesher);
    mesher->Update();
    EXPECT_NE(errors.GetText().find(message), std::string::npos) << errors.GetText();
    EXPECT_EQ(mesher->GetOutput()->GetNumberOfCells(), 0);
  };
  fails("nothing of the surface lies below the waterline z = -2",
    [](Mesher* m)
    {
      m->SetWaterlinePlane(Mesher::ACROSS_Z);
      m->SetWaterlinePosition(-2);
    });
  fails("lie across one axis",
    [](Mesher* m)
    {
      m->SetWaterlinePlane(Mesher::ACROSS_Z);
      m->SetGroundPlane(Mesher::ACROSS_Z);
    });
  fails("does not reach the symmetry plane x = 3",
    [](Mesher* m)
    {
      m->SetSymmetryPlane(Mesher::ACROSS_X);
      m->SetSymmetryPosition(3);
    });
  fails("'hatch' is no type",
    [](Mesher* m)
    {
      m->FarFieldOn();
      m->SetFarFieldSide("xmin", "a", "hatch");
    });
  fails("the far field is a sphere",
    [](Mesher* m)
    {
      m->FarFieldOn();
      m->SetFarFieldShapeToSphere();
      m->SetFarFieldSide("xmin", "a");
    });
}

TEST(MesherDomains, RefusesUnknownSides)
{
  vtkNew<Mesher> mesher;
  ErrorCatcher errors(mesher);
  mesher->SetFarFieldSide("left", "a");
  EXPECT_NE(errors.GetText().find("SetFarFieldSide needs a side"), std::string::npos);
}

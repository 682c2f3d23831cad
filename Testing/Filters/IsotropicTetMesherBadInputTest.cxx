// Surfaces that cannot be meshed, or only after repair: what vtkIsotropicTetMesher says of them.
#include "ErrorCatcher.h"
#include "TestSurfaces.h"

#include "vtkIsotropicTetMesher.h"

#include "Support/DataContract.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
class BadInput : public ::testing::Test
{
protected:
  vtkNew<vtkIsotropicTetMesher> Mesher;

  // The mesher's error message for a surface; there must be no mesh then.
  std::string ErrorFor(vtkPolyData* surface)
  {
    this->Mesher->SetInputDataObject(surface);
    ErrorCatcher errors(this->Mesher);
    this->Mesher->Update();
    EXPECT_EQ(this->Mesher->GetOutput()->GetNumberOfCells(), 0);
    EXPECT_NE(errors.GetText(), "");
    return errors.GetText();
  }

  // The warnings on the way to a mesh.
  std::string WarningFor(vtkPolyData* surface)
  {
    this->Mesher->SetInputDataObject(surface);
    WarningCatcher warnings(this->Mesher);
    ErrorCatcher errors(this->Mesher);
    this->Mesher->Update();
    EXPECT_EQ(errors.GetText(), "");
    EXPECT_GT(this->Mesher->GetOutput()->GetNumberOfCells(), 0);
    return warnings.GetText();
  }

  vtkPolyData* Problems() { return vtkPolyData::SafeDownCast(this->Mesher->GetOutputDataObject(1)); }
};

bool contains(const std::string& text, const char* phrase)
{
  return text.find(phrase) != std::string::npos;
}

const std::vector<std::array<double, 3>> TetPoints = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
const std::vector<std::array<vtkIdType, 3>> TetFaces = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } };
} // namespace

TEST_F(BadInput, Empty)
{
  vtkNew<vtkPolyData> nothing;
  EXPECT_TRUE(contains(this->ErrorFor(nothing), "input is empty"));
}

TEST_F(BadInput, Open)
{
  auto faces = TetFaces;
  faces.pop_back();
  const std::string text = this->ErrorFor(TestSurfaces::Triangles(TetPoints, faces));
  EXPECT_TRUE(contains(text, "not closed: 3 open edges"));
  EXPECT_TRUE(contains(text, "in patch 'surface'"));
  EXPECT_EQ(this->Problems()->GetNumberOfCells(), 3);
  EXPECT_TRUE(this->Problems()->GetCellData()->GetArray(ransmesh::contract::Reason));
}

TEST_F(BadInput, IntersectingItself)
{
  const auto both = TestSurfaces::Together({ TestSurfaces::Sphere(1, 12), TestSurfaces::Sphere(1, 12, 0.7) });
  const std::string text = this->ErrorFor(both);
  EXPECT_TRUE(contains(text, "intersects itself"));
  EXPECT_TRUE(contains(text, "cross near ("));
  EXPECT_GT(this->Problems()->GetNumberOfCells(), 10);
  auto* partner = this->Problems()->GetCellData()->GetArray(ransmesh::contract::PartnerId);
  EXPECT_GE(partner->GetTuple1(0), 0);
}

TEST_F(BadInput, NotFinite)
{
  auto points = TetPoints;
  points[2][1] = std::numeric_limits<double>::quiet_NaN();
  const std::string text = this->ErrorFor(TestSurfaces::Triangles(points, TetFaces));
  EXPECT_TRUE(contains(text, "1 point that is not finite")) << text;
  EXPECT_EQ(this->Problems()->GetNumberOfCells(), 3);
}

TEST_F(BadInput, TooFarAway)
{
  auto points = TetPoints;
  points[3][2] = 1e100;
  EXPECT_TRUE(contains(this->ErrorFor(TestSurfaces::Triangles(points, TetFaces)), "too far away"));
}

TEST_F(BadInput, Flat)
{
  auto points = TetPoints;
  points[3] = { 0.3, 0.3, 0 };
  EXPECT_TRUE(contains(this->ErrorFor(TestSurfaces::Triangles(points, TetFaces)), "no extent along z"));
}

TEST_F(BadInput, FlatButTilted)
{
  auto points = TetPoints;
  points[0] = { 1.0 / 4, 1.0 / 4, 1.0 / 2 }; // in the plane x + y + z = 1 of the others
  EXPECT_TRUE(contains(this->ErrorFor(TestSurfaces::Triangles(points, TetFaces)), "intersects itself"));
}

TEST_F(BadInput, DuplicateTrianglesAreDropped)
{
  auto faces = TetFaces;
  faces.push_back({ 1, 3, 0 });
  EXPECT_TRUE(
    contains(this->WarningFor(TestSurfaces::Triangles(TetPoints, faces)), "1 duplicate triangle dropped"));
}

TEST_F(BadInput, CollapsedTrianglesAreDropped)
{
  auto faces = TetFaces;
  faces.push_back({ 1, 1, 0 });
  EXPECT_TRUE(
    contains(this->WarningFor(TestSurfaces::Triangles(TetPoints, faces)), "two equal corners dropped"));
}

TEST_F(BadInput, FlatTrianglesAreSwapped)
{
  auto points = TetPoints;
  points.push_back({ 0.5, 0, 0 }); // on the edge 0-1: the face below knows it, the one behind does not
  auto faces = TetFaces;
  faces[0] = { 0, 2, 4 };
  faces.push_back({ 4, 2, 1 });
  faces.push_back({ 0, 4, 1 });
  EXPECT_TRUE(contains(this->WarningFor(TestSurfaces::Triangles(points, faces)), "1 flat triangle"));
}

TEST_F(BadInput, TurnedTrianglesAreReported)
{
  auto faces = TetFaces;
  std::swap(faces[1][0], faces[1][1]);
  EXPECT_TRUE(contains(this->WarningFor(TestSurfaces::Triangles(TetPoints, faces)),
    "1 triangle that ran against the neighbours' orientation turned"));
}

TEST_F(BadInput, SheetsInTheFluid)
{
  // Two boxes side by side, the wall between them given by both.
  const std::vector<std::array<double, 3>> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.3, 0.3, 1 },
    { 0.3, 0.3, -1 } };
  const std::string text = this->ErrorFor(TestSurfaces::Triangles(
    points, { { 0, 1, 2 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 0, 4 } }));
  EXPECT_TRUE(contains(text, "fluid on both sides"));
  EXPECT_EQ(this->Problems()->GetNumberOfCells(), 1);
}

TEST_F(BadInput, OptionsOutOfRange)
{
  const auto cube = TestSurfaces::Cube(0, 1);
  this->Mesher->SetSurfaceGrowthRate(0.5);
  EXPECT_TRUE(contains(this->ErrorFor(cube), "SurfaceGrowthRate is 0.5"));
  this->Mesher->SetSurfaceGrowthRate(1.3);
  this->Mesher->SetMaximumEdgeLength(-1);
  EXPECT_TRUE(contains(this->ErrorFor(cube), "MaximumEdgeLength is -1"));
  this->Mesher->SetMaximumEdgeLength(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(contains(this->ErrorFor(cube), "MaximumEdgeLength is nan"));
  this->Mesher->SetMaximumEdgeLength(0);
  this->Mesher->FarFieldOn();
  this->Mesher->SetFarFieldMargins(1, 1, 0, 1, 1, 1);
  EXPECT_TRUE(contains(this->ErrorFor(cube), "FarFieldMargins is 0"));
}

TEST_F(BadInput, SizesBeyondAllBounds)
{
  const auto cube = TestSurfaces::Cube(0, 1);
  this->Mesher->SetMaximumEdgeLength(1e-9);
  EXPECT_TRUE(contains(this->ErrorFor(cube), "too large a mesh"));
  this->Mesher->FarFieldOn();
  this->Mesher->SetMaximumEdgeLength(1e-3);
  EXPECT_TRUE(contains(this->ErrorFor(cube), "too large a mesh"));
}

TEST_F(BadInput, UnknownPatchTypes)
{
  const auto cube = TestSurfaces::Cube(0, 1);
  this->Mesher->SetPatchType("surface", "concrete");
  EXPECT_TRUE(contains(this->ErrorFor(cube), "'concrete' is no type of patch"));
  this->Mesher->ClearPatchTypes();
  this->Mesher->SetPatchType("wing*", "wall");
  EXPECT_TRUE(contains(this->ErrorFor(cube), "no patch is named 'wing*'"));
}

TEST_F(BadInput, IsForgottenWhenTheInputIsMended)
{
  auto faces = TetFaces;
  faces.pop_back();
  this->ErrorFor(TestSurfaces::Triangles(TetPoints, faces));
  this->Mesher->SetInputDataObject(TestSurfaces::Triangles(TetPoints, TetFaces));
  this->Mesher->Update();
  EXPECT_GT(this->Mesher->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(this->Problems()->GetNumberOfCells(), 0);
}

TEST_F(BadInput, SurfaceAngleOutOfRange)
{
  this->Mesher->SetMaximumSurfaceAngle(91);
  EXPECT_TRUE(contains(
    this->ErrorFor(TestSurfaces::Cube(0, 1)), "MaximumSurfaceAngle is 91; it must lie between 0 and 90"));
}

TEST_F(BadInput, FlatTrianglesAreSwappedWithAWarning)
{
  // One side of a cube is cut into a needle and a cap.
  const auto cube = TestSurfaces::Triangles({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
                                              { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 }, { 0.5, 0.49, 1 } },
    { { 0, 2, 1 }, { 0, 3, 2 }, { 0, 1, 5 }, { 0, 5, 4 }, { 1, 2, 6 }, { 1, 6, 5 }, { 2, 3, 7 }, { 2, 7, 6 },
      { 3, 0, 4 }, { 3, 4, 7 }, { 4, 5, 8 }, { 5, 6, 8 }, { 4, 8, 6 }, { 4, 6, 7 } });
  const std::string warning = this->WarningFor(cube);
  EXPECT_TRUE(contains(warning, "1 diagonal of surface triangles swapped")) << warning;
  EXPECT_TRUE(contains(warning, "above 175 degrees: 1 before, 0 after")) << warning;
}

TEST_F(BadInput, RemeshingWhereThreeTrianglesMeet)
{
  this->Mesher->SetSurfaceEdgeLength(0.1);
  const auto twoCells =
    TestSurfaces::Triangles({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.3, 0.3, 1 }, { 0.3, 0.3, -1 } },
      { { 0, 1, 2 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 0, 4 } });
  EXPECT_TRUE(contains(this->ErrorFor(twoCells), "fluid on both sides"));
}

TEST_F(BadInput, RemeshingSheetsNearerThanTheirEdgesBulge)
{
  // The edges that are asked for would make the two sheets cross: they become shorter.
  this->Mesher->SetSurfaceEdgeLength(0.9);
  this->Mesher->AddInputDataObject(
    TestSurfaces::Together({ TestSurfaces::Sphere(1, 40), TestSurfaces::Sphere(1.01, 40) }));
  ErrorCatcher errors(this->Mesher);
  this->Mesher->Update();
  EXPECT_EQ(errors.GetText(), "");
  EXPECT_GT(this->Mesher->GetOutput()->GetNumberOfCells(), 0);
}

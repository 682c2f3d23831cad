// Wakes and walls without thickness: the second input of vtkIsotropicTetMesher.
#include "ErrorCatcher.h"
#include "TestSheets.h"
#include "TestSurfaces.h"

#include "MeshConversion.h"
#include "vtkIsotropicTetMesher.h"

#include "Boundary/SheetSides.h"
#include "Mesh/Validation.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>

namespace
{
using TestSheets::Flat;

class MesherSheets : public ::testing::Test
{
protected:
  vtkNew<vtkIsotropicTetMesher> Mesher;
  WarningCatcher Warnings{ this->Mesher };
  ransmesh::MeshData Mesh;
  ransmesh::PatchTable Patches;
  std::map<std::string, double> SheetArea; // by name, of those that are sheets

  void AddUnitBox(int cells)
  {
    const char* names[] = { "x_low", "x_high", "y_low", "y_high", "z_low", "z_high" };
    vtkNew<vtkMultiBlockDataSet> blocks;
    const auto sides = TestSheets::UnitBoxSides(cells);
    for (unsigned i = 0; i < 6; ++i)
    {
      blocks->SetBlock(i, sides[i]);
      blocks->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), names[i]);
    }
    this->Mesher->AddInputDataObject(0, blocks);
  }

  void Run()
  {
    ErrorCatcher errors(this->Mesher);
    this->Mesher->Update();
    ASSERT_EQ(errors.GetText(), "");
    ASSERT_TRUE(ransmesh::readMesh(this->Mesher->GetOutput(), this->Mesh, this->Patches).ok());
    const ransmesh::MeshFaults faults = ransmesh::findFaults(this->Mesh);
    EXPECT_TRUE(faults.none()) << faults.text();
    EXPECT_TRUE(std::is_sorted(this->Mesh.trianglePatch.begin(), this->Mesh.trianglePatch.end()));
    for (const auto& sheet : ransmesh::findSheets(this->Mesh))
    {
      const auto& v = this->Mesh.triangles[sheet.triangle];
      const auto& a = this->Mesh.points[v[0]];
      const double area = norm(cross(this->Mesh.points[v[1]] - a, this->Mesh.points[v[2]] - a)) / 2;
      this->SheetArea[this->Patches[this->Mesh.trianglePatch[sheet.triangle]].name] += area;
    }
  }

  ransmesh::PatchType TypeOf(const std::string& name) const
  {
    for (const ransmesh::Patch& patch : this->Patches)
    {
      if (patch.name == name)
      {
        return patch.type;
      }
    }
    ADD_FAILURE() << "no patch " << name;
    return ransmesh::PatchType::Patch;
  }

  // The mesher's error message; there must be no mesh then.
  std::string Error()
  {
    ErrorCatcher errors(this->Mesher);
    this->Mesher->Update();
    EXPECT_EQ(this->Mesher->GetOutput()->GetNumberOfCells(), 0);
    return errors.GetText();
  }

  vtkIdType ProblemCount() const
  {
    return vtkPolyData::SafeDownCast(this->Mesher->GetOutputDataObject(1))->GetNumberOfCells();
  }
};

#define EXPECT_SAYS(text, phrase) EXPECT_NE(std::string(text).find(phrase), std::string::npos) << (text)

TEST_F(MesherSheets, AFreeSheetBecomesFacesInside)
{
  this->Mesher->AddInputDataObject(TestSurfaces::Cube(0, 1));
  this->Mesher->AddSheetData(Flat({ 0.3, 0.3, 0.5 }, { 0.4, 0, 0 }, { 0, 0.4, 0.1 }, 4, 4));
  this->Mesher->SetMaximumEdgeLength(0.15);
  this->Run();
  EXPECT_EQ(this->SheetArea.size(), 1u);
  EXPECT_NEAR(this->SheetArea["wake"], 0.4 * std::hypot(0.4, 0.1), 1e-12);
  EXPECT_EQ(this->TypeOf("wake"), ransmesh::PatchType::Wake);
  EXPECT_NEAR(ransmesh::totalVolume(this->Mesh), 1, 1e-12);
  EXPECT_EQ(std::count(this->Mesh.trianglePatch.begin(), this->Mesh.trianglePatch.end(), 2), 32);
}

TEST_F(MesherSheets, SheetsAreDividedAsTheSizesAsk)
{
  this->Mesher->AddInputDataObject(TestSurfaces::Cube(0, 1));
  this->Mesher->AddSheetData(Flat({ 0.3, 0.3, 0.5 }, { 0.4, 0, 0 }, { 0, 0.4, 0 }, 1, 1));
  this->Mesher->SetMaximumEdgeLength(0.15);
  this->Run();
  EXPECT_NEAR(this->SheetArea["wake"], 0.16, 1e-12);
  EXPECT_GT(std::count(this->Mesh.trianglePatch.begin(), this->Mesh.trianglePatch.end(), 2), 8);
}

TEST_F(MesherSheets, AFinStandsOnTheFloor)
{
  this->AddUnitBox(8);
  // A point of its foot is a little off.
  this->Mesher->AddSheetData(Flat({ 0.5, 0.25, 3e-7 }, { 0, 0.5, 0 }, { 0, 0, 0.375 }, 4, 3));
  this->Mesher->SetPatchType("wake", "wall");
  this->Run();
  EXPECT_NEAR(this->SheetArea["wake"], 0.5 * 0.375, 1e-6);
  EXPECT_EQ(this->TypeOf("wake"), ransmesh::PatchType::Wall);
}

TEST_F(MesherSheets, ASheetMayPartTheDomain)
{
  this->AddUnitBox(6);
  this->Mesher->AddSheetData(Flat({ 0.5, 0, 0 }, { 0, 0, 1 }, { 0, 1, 0 }, 6, 6));
  this->Run();
  EXPECT_NEAR(this->SheetArea["wake"], 1, 1e-12);
  EXPECT_NEAR(ransmesh::totalVolume(this->Mesh), 1, 1e-12);
}

TEST_F(MesherSheets, ASheetReachesTheFarField)
{
  // The body's length is 2: the box's side lies at 1 + 2 * 2.
  this->Mesher->AddInputDataObject(TestSurfaces::Cube(-1, 1));
  this->Mesher->FarFieldOn();
  this->Mesher->SetFarFieldMargins(2, 2, 2, 2, 2, 2);
  this->Mesher->AddSheetData(Flat({ 2, -1, 0 }, { 3, 0, 0 }, { 0, 2, 0 }, 6, 4));
  this->Run();
  EXPECT_NEAR(this->SheetArea["wake"], 6, 1e-9);
  EXPECT_EQ(this->Warnings.GetText(), "");
}

TEST_F(MesherSheets, ASheetSpansTheFarFieldFromSideToSide)
{
  this->Mesher->AddInputDataObject(TestSurfaces::Cube(-1, 1));
  this->Mesher->FarFieldOn();
  this->Mesher->SetFarFieldMargins(1, 1, 1, 1, 1, 1);
  // Through edges of the box, in the one direction, and through a corner, in the other.
  this->Mesher->AddSheetData(Flat({ 2, -3, -3 }, { 0, 6, 0 }, { 0, 0, 6 }, 6, 6));
  this->Mesher->AddSheetData(Flat({ -3, -3, -3 }, { 1, 0, 0 }, { 0, 1, 1 }, 2, 2));
  this->Run();
  EXPECT_NEAR(this->SheetArea["wake_1"], 36, 1e-9);
  EXPECT_NEAR(this->SheetArea["wake_2"], std::sqrt(2.0), 1e-9);
}

TEST_F(MesherSheets, NamesAndNumbersComeAsThoseOfSurfaces)
{
  this->Mesher->AddInputDataObject(TestSurfaces::Cube(0, 1));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Flat({ 0.3, 0.3, 0.3 }, { 0.4, 0, 0 }, { 0, 0.4, 0 }, 2, 2));
  blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "tailWake");
  blocks->SetBlock(1, Flat({ 0.3, 0.3, 0.7 }, { 0.4, 0, 0 }, { 0, 0.4, 0 }, 2, 2));
  blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "fin_wall");
  this->Mesher->AddSheetData(blocks);
  vtkSmartPointer<vtkPolyData> numbered = Flat({ 0.3, 0.3, 0.5 }, { 0.4, 0, 0 }, { 0, 0.4, 0 }, 2, 1);
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("PatchId");
  for (const int n : { 1, 1, 9, 9 })
  {
    numbers->InsertNextValue(n);
  }
  numbered->GetCellData()->AddArray(numbers);
  this->Mesher->AddSheetData(numbered);
  this->Run();
  EXPECT_EQ(this->SheetArea.size(), 4u);
  EXPECT_EQ(this->TypeOf("tailWake"), ransmesh::PatchType::Wake);
  EXPECT_EQ(this->TypeOf("fin_wall"), ransmesh::PatchType::Wall);
  EXPECT_NEAR(this->SheetArea["wake_3_1"], 0.08, 1e-12);
  EXPECT_EQ(this->Patches.at(9).name, "wake_3_9");
}

TEST_F(MesherSheets, ASheetOutsideTheFluidIsLeftOutWithAWarning)
{
  this->Mesher->AddInputDataObject(TestSurfaces::Cube(0, 1));
  this->Mesher->AddSheetData(Flat({ 2, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 2, 2));
  this->Run();
  EXPECT_TRUE(this->SheetArea.empty());
  EXPECT_SAYS(this->Warnings.GetText(), "the sheet 'wake' does not lie in the fluid: left out");
}

TEST_F(MesherSheets, ASheetThroughASurfaceIsAnError)
{
  this->Mesher->AddInputDataObject(TestSurfaces::Cube(0, 1));
  this->Mesher->AddSheetData(Flat({ 0.5, 0.5, 0.5 }, { 1, 0, 0 }, { 0, 0.2, 0 }, 2, 2));
  EXPECT_SAYS(this->Error(), "the sheet 'wake' cuts or touches 'surface'");
  EXPECT_GT(this->ProblemCount(), 0);
}

TEST_F(MesherSheets, ABorderOnASurfaceThatDoesNotFitIsAnError)
{
  this->AddUnitBox(8);
  this->Mesher->AddSheetData(Flat({ 0.5, 0.3, 0 }, { 0, 0.5, 0 }, { 0, 0, 0.375 }, 4, 3));
  EXPECT_SAYS(this->Error(), "their points must coincide, each edge of its border an edge of both");
  EXPECT_GT(this->ProblemCount(), 0);
}

TEST_F(MesherSheets, ABorderJustAboveASurfaceIsAnError)
{
  this->AddUnitBox(8);
  this->Mesher->AddSheetData(Flat({ 0.5, 0.3, 5e-7 }, { 0, 0.5, 0 }, { 0, 0, 0.375 }, 4, 3));
  const std::string error = this->Error();
  EXPECT_SAYS(error, "the border of the sheet 'wake' lies on 'z_low' without sharing its points");
  EXPECT_SAYS(error, "the first at (0.5, 0.3");
  EXPECT_GT(this->ProblemCount(), 0);
}

TEST_F(MesherSheets, SheetsThatCrossAreAnError)
{
  this->Mesher->AddInputDataObject(TestSurfaces::Cube(0, 1));
  this->Mesher->AddSheetData(Flat({ 0.3, 0.3, 0.5 }, { 0.4, 0, 0 }, { 0, 0.4, 0 }, 2, 2));
  this->Mesher->AddSheetData(Flat({ 0.45, 0.3, 0.3 }, { 0, 0.4, 0 }, { 0, 0, 0.4 }, 3, 3));
  EXPECT_SAYS(this->Error(), "the sheet 'wake_2' cuts or touches 'wake_1'");
}

TEST_F(MesherSheets, WhatReachesOutOfTheBoxIsCutOff)
{
  this->Mesher->AddInputDataObject(TestSurfaces::Sphere(1, 16));
  this->Mesher->FarFieldOn();
  this->Mesher->SetFarFieldMargins(2, 2, 2, 2, 2, 2);
  this->Mesher->AddSheetData(Flat({ 2, -1, 0 }, { 4, 0, 0 }, { 0, 2, 0 }, 7, 4));
  this->Run();
  double bounds[6];
  this->Mesher->GetOutput()->GetBounds(bounds);
  EXPECT_NEAR(this->SheetArea["wake"], 2 * (bounds[1] - 2), 1e-9);
  EXPECT_SAYS(this->Warnings.GetText(), "triangles cut off at the far-field box of sheets");
}

TEST_F(MesherSheets, ASheetOutsideTheBoxIsAnError)
{
  this->Mesher->AddInputDataObject(TestSurfaces::Cube(-1, 1));
  this->Mesher->FarFieldOn();
  this->Mesher->SetFarFieldMargins(2, 2, 2, 2, 2, 2);
  this->Mesher->AddSheetData(Flat({ 7, -1, 0 }, { 4, 0, 0 }, { 0, 2, 0 }, 4, 4));
  const std::string error = this->Error();
  EXPECT_SAYS(error, "all sheets ('wake' and what follows) lie outside the far-field box");
  EXPECT_SAYS(error, "FarFieldMargins");
}

TEST_F(MesherSheets, ASheetMustHaveANameOfItsOwn)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, TestSurfaces::Cube(0, 1));
  blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "wake");
  this->Mesher->AddInputDataObject(blocks);
  this->Mesher->AddSheetData(Flat({ 0.3, 0.3, 0.5 }, { 0.4, 0, 0 }, { 0, 0.4, 0 }, 2, 2));
  EXPECT_SAYS(this->Error(), "the patch 'wake' is there in the surfaces and in the sheets");
}

TEST_F(MesherSheets, ASheetCannotBeASymmetry)
{
  this->Mesher->AddInputDataObject(TestSurfaces::Cube(0, 1));
  this->Mesher->AddSheetData(Flat({ 0.3, 0.3, 0.5 }, { 0.4, 0, 0 }, { 0, 0.4, 0 }, 2, 2));
  this->Mesher->SetPatchType("wake", "symmetry");
  EXPECT_SAYS(this->Error(), "the sheet 'wake' is of type symmetry: a sheet lies inside the fluid");
}

TEST_F(MesherSheets, ASheetMustBeFinite)
{
  this->Mesher->AddInputDataObject(TestSurfaces::Cube(0, 1));
  auto sheet = Flat({ 0.3, 0.3, 0.5 }, { 0.4, 0, 0 }, { 0, 0.4, 0 }, 2, 2);
  sheet->GetPoints()->SetPoint(4, 0, std::numeric_limits<double>::quiet_NaN(), 0);
  this->Mesher->AddSheetData(sheet);
  EXPECT_SAYS(this->Error(), "of the sheet is not finite");
}

TEST_F(MesherSheets, DegenerateTrianglesOfSheetsAreShown)
{
  this->Mesher->AddInputDataObject(TestSurfaces::Cube(0, 1));
  this->Mesher->AddSheetData(
    TestSurfaces::Triangles({ { 0.3, 0.3, 0.5 }, { 0.5, 0.3, 0.5 }, { 0.7, 0.3, 0.5 } }, { { 0, 1, 2 } }));
  EXPECT_SAYS(this->Error(), "the sheets have 1 triangles without area");
  EXPECT_EQ(this->ProblemCount(), 1);
}

TEST_F(MesherSheets, AreRemeshedWithTheSurfacesThatTheyEndOn)
{
  this->AddUnitBox(4);
  this->Mesher->AddSheetData(Flat({ 0.5, 0, 0 }, { 0, 1, 0 }, { 0, 0, 0.5 }, 4, 2)); // ends on three sides
  this->Mesher->SetSurfaceEdgeLength(0.12);
  this->Run();
  EXPECT_NEAR(this->SheetArea.at("wake"), 0.5, 1e-9);
  EXPECT_GT(ransmesh::findSheets(this->Mesh).size(), 60u); // 16 as given
}
} // namespace

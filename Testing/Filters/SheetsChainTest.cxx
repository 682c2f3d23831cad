// A mesh with a wake through the filters that follow the mesher.
#include "ErrorCatcher.h"
#include "MeshConversion.h"
#include "Support/GridMesh.h"

#include "Boundary/SheetSides.h"
#include "Mesh/Validation.h"
#include "Support/DataContract.h"

#include "vtkCellData.h"
#include "vtkDirectionalEnrichment.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkMeshQualityReport.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRANSPointRemoval.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
constexpr int Layers = 6;
constexpr int Wake = 7;

class SheetsChain : public ::testing::Test
{
protected:
  vtkNew<vtkUnstructuredGrid> Grid;
  vtkNew<vtkRANSPointRemoval> Removal;
  vtkNew<vtkDirectionalEnrichment> Enrichment;
  vtkNew<vtkMeshQualityReport> Report;

  void SetUp() override
  {
    ransmesh::MeshData mesh = grid_mesh::make({ 8, 8, 8 });
    const int patch = grid_mesh::addSheet(mesh,
      [](const ransmesh::Vector3& p)
      { return std::fabs(p.z - 0.5) < 1e-9 && p.x > 0.25 && p.y > 0.25 && p.y < 0.75; });
    EXPECT_EQ(patch, Wake);
    ransmesh::PatchTable table = grid_mesh::patches(ransmesh::PatchType::FarField, Wake);
    table[Wake] = { "wake", ransmesh::PatchType::Wake };
    ransmesh::writeMesh(mesh, table, this->Grid);
    vtkNew<vtkDoubleArray> heights;
    heights->SetName("Height");
    for (vtkIdType i = 0; i < this->Grid->GetNumberOfPoints(); ++i)
    {
      heights->InsertNextValue(this->Grid->GetPoint(i)[2]);
    }
    this->Grid->GetPointData()->AddArray(heights);
    this->Removal->SetInputData(this->Grid);
    this->Removal->SetFirstHeight(0.01);
    this->Removal->SetNumberOfLayers(Layers);
    this->Enrichment->SetInputConnection(this->Removal->GetOutputPort());
    this->Report->SetInputConnection(0, this->Enrichment->GetOutputPort(0));
    this->Report->SetInputConnection(1, this->Enrichment->GetOutputPort(1));
  }

  static ransmesh::MeshData Read(vtkUnstructuredGrid* grid)
  {
    ransmesh::MeshData mesh;
    ransmesh::PatchTable patches;
    EXPECT_TRUE(ransmesh::readMesh(grid, mesh, patches).ok());
    return mesh;
  }

  static void ExpectValidWithSheet(vtkUnstructuredGrid* grid)
  {
    const ransmesh::MeshData mesh = Read(grid);
    const ransmesh::MeshFaults faults = ransmesh::findFaults(mesh);
    EXPECT_TRUE(faults.none()) << faults.text();
    double area = 0;
    for (const auto& sheet : ransmesh::findSheets(mesh))
    {
      EXPECT_EQ(mesh.trianglePatch[sheet.triangle], Wake);
      const auto& v = mesh.triangles[sheet.triangle];
      const auto& a = mesh.points[v[0]];
      area += norm(cross(mesh.points[v[1]] - a, mesh.points[v[2]] - a)) / 2;
    }
    EXPECT_NEAR(area, 0.75 * 0.5, 1e-12);
    EXPECT_TRUE(std::is_sorted(mesh.trianglePatch.begin(), mesh.trianglePatch.end()));
  }

  // Arrays of points stay with their points.
  static void ExpectHeightsOfOldPoints(vtkUnstructuredGrid* grid)
  {
    vtkDataArray* heights = grid->GetPointData()->GetArray("Height");
    ASSERT_TRUE(heights);
    ASSERT_EQ(heights->GetNumberOfTuples(), grid->GetNumberOfPoints());
    for (const auto& triangle : Read(grid).triangles)
    {
      for (const ransmesh::Index v : triangle)
      {
        EXPECT_NEAR(heights->GetTuple1(v), grid->GetPoint(v)[2], 0.2);
      }
    }
  }
};

TEST_F(SheetsChain, EveryStageGivesAValidMeshWithTheSheetInIt)
{
  ErrorCatcher errors(this->Report);
  this->Report->Update();
  EXPECT_EQ(errors.GetText(), "");
  EXPECT_GT(this->Removal->GetNumberOfRemovedPoints(), 0);
  ExpectValidWithSheet(this->Removal->GetOutput());
  ExpectValidWithSheet(this->Enrichment->GetOutput());
  ExpectHeightsOfOldPoints(this->Removal->GetOutput());
  ExpectHeightsOfOldPoints(this->Enrichment->GetOutput());
  EXPECT_TRUE(this->Report->GetValid());
  EXPECT_NE(std::string(this->Report->GetReportText()).find("wake sheet"), std::string::npos);
}

TEST_F(SheetsChain, TheBoundaryOutputShowsBothSides)
{
  this->Enrichment->Update();
  auto* boundary = vtkPolyData::SafeDownCast(this->Enrichment->GetOutputDataObject(1));
  const auto countOf = [](vtkDataArray* patches)
  {
    vtkIdType count = 0;
    for (vtkIdType i = 0; i < patches->GetNumberOfTuples(); ++i)
    {
      count += patches->GetTuple1(i) == Wake;
    }
    return count;
  };
  const char* name = ransmesh::contract::PatchId;
  EXPECT_EQ(countOf(boundary->GetCellData()->GetArray(name)),
    2 * countOf(this->Enrichment->GetOutput()->GetCellData()->GetArray(name)));
}

TEST_F(SheetsChain, ASheetWithoutLayersStaysAsItIs)
{
  this->Removal->AddWallPatch("z_low");
  this->Report->Update();
  ExpectValidWithSheet(this->Removal->GetOutput());
  ExpectValidWithSheet(this->Enrichment->GetOutput());
  EXPECT_GT(this->Enrichment->GetNumberOfInsertedPoints(), 0);
}

TEST_F(SheetsChain, ASheetThatIsPartlyOnTheBoundaryIsRefused)
{
  auto* patches = vtkIntArray::SafeDownCast(this->Grid->GetCellData()->GetArray("PatchId"));
  for (vtkIdType i = 0; i < patches->GetNumberOfValues(); ++i)
  {
    patches->SetValue(i, patches->GetValue(i) == Wake ? 1 : patches->GetValue(i));
  }
  ErrorCatcher errors(this->Removal);
  this->Removal->AddWallPatch("z_low");
  this->Removal->Update();
  EXPECT_TRUE(errors.Says("triangles off the boundary")) << errors.GetText();
  EXPECT_EQ(this->Removal->GetOutput()->GetNumberOfCells(), 0);
}
} // namespace

#include "vtkMeshQualityReport.h"

#include "../Kernel/Support/LayeredBox.h"
#include "ErrorCatcher.h"

#include "MeshConversion.h"
#include "Support/DataContract.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <sstream>

namespace
{
namespace contract = ransmesh::contract;

constexpr int Layers = 10;

ransmesh::MeshData LayeredMesh()
{
  return layered_box::make(6, 6, 0.25, layered_box::levels(1e-3, 1.2, Layers, 0.5));
}

void MakeGrid(const ransmesh::MeshData& mesh, bool withPlan, vtkUnstructuredGrid* grid)
{
  ransmesh::writeMesh(mesh, layered_box::patches(), grid);
  if (withPlan)
  {
    ransmesh::LayerPlan plan(layered_box::patches().size());
    plan[layered_box::Floor].firstHeight = 1e-3;
    plan[layered_box::Floor].numberOfLayers = Layers;
    ransmesh::writePlan(plan, grid->GetFieldData());
  }
}

double Figure(vtkTable* summary, const std::string& quantity, const std::string& scope)
{
  auto* quantities = vtkStringArray::SafeDownCast(summary->GetColumnByName("Quantity"));
  auto* scopes = vtkStringArray::SafeDownCast(summary->GetColumnByName("Scope"));
  for (vtkIdType row = 0; row < summary->GetNumberOfRows(); ++row)
  {
    if (quantities->GetValue(row) == quantity && scopes->GetValue(row) == scope)
    {
      return summary->GetValueByName(row, "Value").ToDouble();
    }
  }
  ADD_FAILURE() << "no row " << quantity << " of " << scope;
  return 0;
}

TEST(MeshQualityReport, describesALayeredMesh)
{
  vtkNew<vtkUnstructuredGrid> grid;
  MakeGrid(LayeredMesh(), true, grid);
  vtkNew<vtkMeshQualityReport> report;
  report->SetInputData(grid);
  report->Update();
  EXPECT_TRUE(report->GetValid());
  auto* summary = vtkTable::SafeDownCast(report->GetOutputDataObject(1));
  ASSERT_NE(summary, nullptr);
  EXPECT_EQ(Figure(summary, "Valid", "whole"), 1);
  EXPECT_EQ(Figure(summary, "Tetrahedra", "whole"), 6 * 6 * 6 * (Layers + 1));
  EXPECT_EQ(Figure(summary, "ShareOfColumnsFull", "floor"), 1);
  EXPECT_NEAR(Figure(summary, "GrowthAchieved p50", "whole"), 1.2, 1e-9);
  EXPECT_NE(std::string(report->GetReportText()).find("floor"), std::string::npos);
}

TEST(MeshQualityReport, addsCellArrays)
{
  vtkNew<vtkUnstructuredGrid> grid;
  MakeGrid(LayeredMesh(), false, grid);
  vtkNew<vtkMeshQualityReport> report;
  report->SetInputData(grid);
  report->Update();
  vtkCellData* cells = report->GetOutput()->GetCellData();
  for (const char* name : { contract::Volume, contract::LargestDihedral, contract::SmallestDihedral,
         contract::Stretching, contract::Quality, contract::PatchId })
  {
    ASSERT_NE(cells->GetArray(name), nullptr) << name;
    EXPECT_EQ(cells->GetArray(name)->GetNumberOfTuples(), grid->GetNumberOfCells()) << name;
  }
  EXPECT_EQ(grid->GetCellData()->GetArray(contract::Volume), nullptr) << "the input was changed";
  double volume = 0;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    volume += cells->GetArray(contract::Volume)->GetTuple1(c);
  }
  EXPECT_NEAR(volume, 1.5 * 1.5 * 0.5, 1e-12);
  // Triangles show the tetrahedron behind them.
  const vtkIdType last = grid->GetNumberOfCells() - 1;
  EXPECT_GT(cells->GetArray(contract::Quality)->GetTuple1(last), 0);
  EXPECT_GE(cells->GetArray(contract::LargestDihedral)->GetTuple1(last), 60);
}

TEST(MeshQualityReport, histogramsCountEveryTetrahedron)
{
  vtkNew<vtkUnstructuredGrid> grid;
  MakeGrid(LayeredMesh(), true, grid);
  vtkNew<vtkMeshQualityReport> report;
  report->SetInputData(grid);
  report->Update();
  auto* table = vtkTable::SafeDownCast(report->GetOutputDataObject(2));
  ASSERT_NE(table, nullptr);
  vtkIdType dihedral = 0;
  vtkIdType columns = 0;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const std::string quantity = table->GetValueByName(row, "Quantity").ToString();
    const std::string scope = table->GetValueByName(row, "Scope").ToString();
    const vtkIdType count = table->GetValueByName(row, "Count").ToInt();
    EXPECT_LT(
      table->GetValueByName(row, "BinLow").ToDouble(), table->GetValueByName(row, "BinHigh").ToDouble());
    dihedral += quantity == "LargestDihedral" && scope == "whole" ? count : 0;
    columns += quantity == "LayersPerColumn" && scope == "floor" ? count : 0;
  }
  EXPECT_EQ(dihedral, 6 * 6 * 6 * (Layers + 1));
  EXPECT_EQ(columns, 49);
}

TEST(MeshQualityReport, anInvalidMeshIsReportedNotAnError)
{
  ransmesh::MeshData mesh = LayeredMesh();
  std::swap(mesh.tetrahedra[5][0], mesh.tetrahedra[5][1]);
  vtkNew<vtkUnstructuredGrid> grid;
  MakeGrid(mesh, true, grid);
  vtkNew<vtkMeshQualityReport> report;
  const ErrorCatcher errors(report);
  report->SetInputData(grid);
  report->Update();
  EXPECT_EQ(errors.GetText(), "");
  EXPECT_FALSE(report->GetValid());
  auto* summary = vtkTable::SafeDownCast(report->GetOutputDataObject(1));
  EXPECT_EQ(Figure(summary, "TetrahedraNotPositive", "whole"), 1);
  EXPECT_NE(std::string(report->GetReportText()).find("INVALID"), std::string::npos);
}

TEST(MeshQualityReport, pointsNotFiniteAreReported)
{
  ransmesh::MeshData mesh = LayeredMesh();
  mesh.points[3].x = NAN;
  vtkNew<vtkUnstructuredGrid> grid;
  MakeGrid(mesh, true, grid);
  vtkNew<vtkMeshQualityReport> report;
  report->SetInputData(grid);
  report->Update();
  EXPECT_FALSE(report->GetValid());
  EXPECT_EQ(report->GetOutput()->GetNumberOfCells(), grid->GetNumberOfCells());
  EXPECT_EQ(report->GetOutput()->GetCellData()->GetArray(contract::Volume), nullptr);
}

TEST(MeshQualityReport, refusesAMeshWithoutTetrahedra)
{
  vtkNew<vtkUnstructuredGrid> empty;
  vtkNew<vtkMeshQualityReport> report;
  const ErrorCatcher errors(report);
  report->SetInputData(empty);
  report->Update();
  EXPECT_TRUE(errors.Says("empty")) << errors.GetText();
  EXPECT_EQ(report->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_STREQ(report->GetReportText(), "");
}

TEST(MeshQualityReport, tellsWhyColumnsStopped)
{
  vtkNew<vtkUnstructuredGrid> grid;
  MakeGrid(LayeredMesh(), true, grid);
  vtkNew<vtkPolyData> boundary;
  vtkNew<vtkIntArray> reasons;
  reasons->SetName(contract::StopReason);
  for (const int code : { 0, 0, 2, 1, 2, 2, 77 }) // 77 has no name, and is left out
  {
    reasons->InsertNextValue(code);
  }
  boundary->GetPointData()->AddArray(reasons);
  vtkNew<vtkStringArray> names;
  names->SetName(contract::StopReasonNames);
  names->InsertNextValue("none");
  names->InsertNextValue("isotropic size reached");
  names->InsertNextValue("gap");
  boundary->GetFieldData()->AddArray(names);
  vtkNew<vtkMeshQualityReport> report;
  report->SetInputData(0, grid);
  report->SetInputData(1, boundary);
  report->Update();
  auto* summary = vtkTable::SafeDownCast(report->GetOutputDataObject(1));
  EXPECT_EQ(Figure(summary, "ColumnsStopped gap", "whole"), 3);
  EXPECT_EQ(Figure(summary, "ColumnsStopped isotropic size reached", "whole"), 1);
  EXPECT_NE(std::string(report->GetReportText()).find("gap 3"), std::string::npos);
}

TEST(MeshQualityReport, writesJson)
{
  vtkNew<vtkUnstructuredGrid> grid;
  MakeGrid(LayeredMesh(), true, grid);
  vtkNew<vtkMeshQualityReport> report;
  const ErrorCatcher errors(report);
  EXPECT_FALSE(report->WriteJson("nothing.json"));
  EXPECT_TRUE(errors.Says("Update"));
  report->SetInputData(grid);
  report->Update();
  const std::string file = testing::TempDir() + "mesh-quality-report-test.json";
  EXPECT_TRUE(report->WriteJson(file.c_str()));
  std::ostringstream read;
  read << std::ifstream(file).rdbuf();
  EXPECT_EQ(read.str(), report->GetReportJson());
  std::remove(file.c_str());
  EXPECT_FALSE(report->WriteJson("/no/such/folder/report.json"));
  EXPECT_TRUE(errors.Says("/no/such/folder"));
}

TEST(MeshQualityReport, itsOptionsDecideWhatCounts)
{
  vtkNew<vtkUnstructuredGrid> grid;
  MakeGrid(LayeredMesh(), true, grid);
  vtkNew<vtkMeshQualityReport> report;
  report->SetInputData(grid);
  report->SetColumnCone(0);
  report->Update();
  EXPECT_EQ(
    Figure(vtkTable::SafeDownCast(report->GetOutputDataObject(1)), "ShareOfColumnsEmpty", "floor"), 1);
  report->SetColumnCone(20);
  report->SetSmoothAngle(0);
  report->Update();
  EXPECT_EQ(Figure(vtkTable::SafeDownCast(report->GetOutputDataObject(1)), "SmoothWallPoints", "floor"), 0);
}
} // namespace

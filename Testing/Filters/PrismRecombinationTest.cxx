#include "vtkPrismRecombination.h"

#include "ErrorCatcher.h"
#include "MeshConversion.h"
#include "MixedConversion.h"
#include "Support/GridMesh.h"

#include "Mesh/MixedValidation.h"
#include "Support/DataContract.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDirectionalEnrichment.h"
#include "vtkDoubleArray.h"
#include "vtkMeshQualityReport.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace
{
namespace contract = ransmesh::contract;
using grid_mesh::ZLow;

constexpr int Layers = 6;

class PrismRecombination : public testing::Test
{
protected:
  // A plate with layers; walls: patches of the cube's sides.
  void MakeLayers(const std::set<int>& walls)
  {
    ransmesh::PatchTable table = grid_mesh::patches(ransmesh::PatchType::Symmetry);
    for (const int wall : walls)
    {
      table[wall] = { "wall_" + std::to_string(wall), ransmesh::PatchType::Wall };
    }
    ransmesh::writeMesh(grid_mesh::make({ 5, 4, 4, {}, 0.1 }), table, this->Plain);
    this->Layered->SetInputData(this->Plain);
    this->Layered->SetFirstHeight(1e-4);
    this->Layered->SetNumberOfLayers(Layers);
    this->Filter->SetInputConnection(this->Layered->GetOutputPort());
  }

  ransmesh::MixedMesh Read(vtkUnstructuredGrid* grid)
  {
    ransmesh::MixedMesh mesh;
    ransmesh::PatchTable patches;
    std::vector<ransmesh::Index> cells;
    std::vector<ransmesh::Index> boundary;
    EXPECT_TRUE(ransmesh::readMixedMesh(grid, mesh, patches, cells, boundary).ok());
    const auto faults = ransmesh::findFaults(mesh);
    EXPECT_TRUE(faults.none()) << faults.text();
    return mesh;
  }

  vtkNew<vtkUnstructuredGrid> Plain;
  vtkNew<vtkDirectionalEnrichment> Layered;
  vtkNew<vtkPrismRecombination> Filter;
};
} // namespace

TEST_F(PrismRecombination, AllLayersOfAPlateBecomeWedges)
{
  this->MakeLayers({ ZLow });
  this->Filter->Update();
  const ransmesh::MixedMesh mesh = this->Read(this->Filter->GetOutput());
  EXPECT_EQ(this->Filter->GetShareOfLayers(), 1);
  EXPECT_EQ(this->Filter->GetNumberOfWedges(), 2 * 5 * 4 * Layers);
  EXPECT_EQ(mesh.wedges.size(), 2U * 5 * 4 * Layers);
  EXPECT_EQ(this->Filter->GetNumberOfPyramids(), 0);
  EXPECT_EQ(this->Filter->GetNumberOfAddedPoints(), 0);
}

TEST_F(PrismRecombination, CellsKeepTheirArrays)
{
  this->MakeLayers({ ZLow });
  this->Filter->Update();
  vtkUnstructuredGrid* grid = this->Filter->GetOutput();
  vtkDataArray* layers = grid->GetCellData()->GetArray(contract::LayerId);
  vtkDataArray* patches = grid->GetCellData()->GetArray(contract::PatchId);
  ASSERT_TRUE(layers && patches);
  EXPECT_EQ(patches->GetNumberOfTuples(), grid->GetNumberOfCells());
  std::map<int, int> wedgesOfLayer;
  bool onBoundary = false;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    const int type = grid->GetCellType(c);
    const bool isFluid = type == VTK_TETRA || type == VTK_PYRAMID || type == VTK_WEDGE;
    onBoundary = onBoundary || !isFluid;
    EXPECT_NE(isFluid, onBoundary) << "cells of the fluid come first";
    EXPECT_EQ(patches->GetTuple1(c) == 0, isFluid);
    if (type == VTK_WEDGE)
    {
      ++wedgesOfLayer[static_cast<int>(layers->GetTuple1(c))];
    }
  }
  for (int layer = 1; layer <= Layers; ++layer)
  {
    EXPECT_EQ(wedgesOfLayer[layer], 2 * 5 * 4) << "layer " << layer;
  }
  EXPECT_EQ(
    grid->GetPointData()->GetArray(contract::ColumnId)->GetNumberOfTuples(), grid->GetNumberOfPoints());
  EXPECT_TRUE(grid->GetFieldData()->GetAbstractArray(contract::PatchNames));
}

TEST_F(PrismRecombination, ConcaveEdgesAndCornersBecomeHexahedraAndStayConforming)
{
  this->MakeLayers({ ZLow, grid_mesh::XLow, grid_mesh::YLow }); // tensor grids inside the cube
  this->Filter->Update();
  const ransmesh::MixedMesh mesh = this->Read(this->Filter->GetOutput());
  EXPECT_GT(mesh.hexahedra.size(), 0U);
  EXPECT_EQ(static_cast<std::size_t>(this->Filter->GetNumberOfHexahedra()), mesh.hexahedra.size());
  EXPECT_GT(this->Filter->GetShareOfLayers(), 0.95);
}

TEST_F(PrismRecombination, TheReportKnowsPrisms)
{
  this->MakeLayers({ ZLow });
  vtkNew<vtkMeshQualityReport> report;
  report->SetInputConnection(this->Filter->GetOutputPort());
  report->Update();
  EXPECT_TRUE(report->GetValid()) << report->GetReportText();
  EXPECT_NE(std::string(report->GetReportText()).find("240 wedges (100 % of the layers)"), std::string::npos)
    << report->GetReportText();
  EXPECT_NE(std::string(report->GetReportJson()).find("\"Wedges\": 240"), std::string::npos);
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(report->GetOutputDataObject(0));
  vtkDataArray* volume = grid->GetCellData()->GetArray(contract::Volume);
  double total = 0;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    total += volume->GetTuple1(c);
  }
  EXPECT_NEAR(total, 1, 1e-12);
}

TEST_F(PrismRecombination, TheReportSeesAFaultOfPrisms)
{
  this->MakeLayers({ ZLow });
  this->Filter->Update();
  vtkNew<vtkUnstructuredGrid> broken;
  broken->DeepCopy(this->Filter->GetOutput());
  for (vtkIdType c = 0; c < broken->GetNumberOfCells(); ++c)
  {
    if (broken->GetCellType(c) == VTK_WEDGE)
    {
      vtkNew<vtkIdList> points;
      broken->GetCellPoints(c, points);
      const vtkIdType turned[] = { points->GetId(0), points->GetId(2), points->GetId(1), points->GetId(3),
        points->GetId(5), points->GetId(4) };
      broken->GetCells()->ReplaceCellAtId(c, 6, turned);
      break;
    }
  }
  vtkNew<vtkMeshQualityReport> report;
  report->SetInputData(broken);
  report->Update();
  EXPECT_FALSE(report->GetValid());
  EXPECT_NE(std::string(report->GetReportText()).find("INVALID: 1 cells with a corner"), std::string::npos)
    << report->GetReportText();
}

TEST_F(PrismRecombination, WithoutPrismIdItSaysWhatToDo)
{
  this->MakeLayers({ ZLow });
  this->Filter->SetInputData(this->Plain);
  ErrorCatcher errors(this->Filter);
  this->Filter->Update();
  EXPECT_TRUE(errors.Says("PrismId")) << errors.GetText();
  EXPECT_TRUE(errors.Says("vtkDirectionalEnrichment")) << errors.GetText();
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfCells(), 0);
}

#include "vtkDirectionalEnrichment.h"

#include "ErrorCatcher.h"
#include "MeshConversion.h"
#include "Support/GridMesh.h"

#include "Mesh/Validation.h"
#include "Support/DataContract.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRANSPointRemoval.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace
{
namespace contract = ransmesh::contract;
using grid_mesh::ZLow;

constexpr int Layers = 8;

void MakePlate(vtkUnstructuredGrid* grid)
{
  ransmesh::PatchTable table = grid_mesh::patches(ransmesh::PatchType::Symmetry);
  table[ZLow] = { "plate", ransmesh::PatchType::Wall };
  ransmesh::writeMesh(grid_mesh::make({ 5, 4, 4, {}, 0.1 }), table, grid);
}

ransmesh::MeshData Read(vtkUnstructuredGrid* grid)
{
  ransmesh::MeshData mesh;
  ransmesh::PatchTable patches;
  EXPECT_TRUE(ransmesh::readMesh(grid, mesh, patches).ok());
  return mesh;
}

class DirectionalEnrichment : public testing::Test
{
protected:
  void SetUp() override
  {
    MakePlate(this->Plate);
    this->Filter->SetInputData(this->Plate);
    this->Filter->SetFirstHeight(1e-4);
    this->Filter->SetNumberOfLayers(Layers);
  }

  void ExpectRefusal(const char* phrase)
  {
    ErrorCatcher errors(this->Filter);
    this->Filter->Update();
    EXPECT_TRUE(errors.Says(phrase)) << errors.GetText();
    EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfCells(), 0);
    auto* boundary = vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(1));
    EXPECT_EQ(boundary->GetNumberOfCells(), 0);
  }

  vtkNew<vtkUnstructuredGrid> Plate;
  vtkNew<vtkDirectionalEnrichment> Filter;
};
} // namespace

TEST_F(DirectionalEnrichment, MakesAValidMeshWithItsArrays)
{
  ErrorCatcher errors(this->Filter);
  this->Filter->Update();
  EXPECT_EQ(errors.GetText(), "");
  vtkUnstructuredGrid* output = this->Filter->GetOutput();
  const auto faults = ransmesh::findFaults(Read(output));
  EXPECT_TRUE(faults.none()) << faults.text();
  EXPECT_EQ(this->Filter->GetNumberOfRequestedPoints(), 6 * 5 * Layers);
  EXPECT_EQ(this->Filter->GetNumberOfInsertedPoints(), 6 * 5 * Layers);

  auto* layer = vtkIntArray::SafeDownCast(output->GetCellData()->GetArray(contract::LayerId));
  auto* prism = vtkIntArray::SafeDownCast(output->GetCellData()->GetArray(contract::PrismId));
  auto* patch = vtkIntArray::SafeDownCast(output->GetCellData()->GetArray(contract::PatchId));
  auto* column = vtkIntArray::SafeDownCast(output->GetPointData()->GetArray(contract::ColumnId));
  ASSERT_TRUE(layer && prism && patch && column);
  EXPECT_EQ(layer->GetRange()[1], Layers);
  vtkIdType inLayers = 0;
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    const bool isTet = output->GetCellType(c) == VTK_TETRA;
    EXPECT_EQ(isTet, patch->GetValue(c) == 0);
    EXPECT_EQ(layer->GetValue(c) > 0, prism->GetValue(c) >= 0);
    inLayers += layer->GetValue(c) > 0;
  }
  EXPECT_EQ(inLayers, 5 * 4 * 2 * 3 * Layers);
}

TEST_F(DirectionalEnrichment, ReportsOnTheBoundary)
{
  this->Filter->Update();
  auto* boundary = vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(1));
  auto* asked = boundary->GetPointData()->GetArray(contract::LayersAsked);
  auto* achieved = boundary->GetPointData()->GetArray(contract::LayersAchieved);
  auto* firstAsked = boundary->GetPointData()->GetArray(contract::FirstHeightAsked);
  auto* first = boundary->GetPointData()->GetArray(contract::FirstHeightAchieved);
  auto* reason = boundary->GetPointData()->GetArray(contract::StopReason);
  auto* names =
    vtkStringArray::SafeDownCast(boundary->GetFieldData()->GetAbstractArray(contract::StopReasonNames));
  ASSERT_TRUE(asked && achieved && firstAsked && first && reason && names);
  EXPECT_EQ(names->GetValue(0), "none");
  EXPECT_TRUE(boundary->GetCellData()->GetArray(contract::PatchId));
  int onWall = 0;
  for (vtkIdType i = 0; i < boundary->GetNumberOfPoints(); ++i)
  {
    if (boundary->GetPoint(i)[2] == 0)
    {
      ++onWall;
      EXPECT_EQ(asked->GetTuple1(i), Layers);
      EXPECT_EQ(achieved->GetTuple1(i), Layers);
      EXPECT_EQ(firstAsked->GetTuple1(i), 1e-4);
      EXPECT_NEAR(first->GetTuple1(i), 1e-4, 1e-10);
      EXPECT_EQ(reason->GetTuple1(i), 0);
    }
    else
    {
      EXPECT_EQ(asked->GetTuple1(i), 0);
    }
  }
  EXPECT_EQ(onWall, 6 * 5);
}

TEST_F(DirectionalEnrichment, CarriesPointAndFieldData)
{
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  for (vtkIdType i = 0; i < this->Plate->GetNumberOfPoints(); ++i)
  {
    height->InsertNextValue(this->Plate->GetPoint(i)[2]);
  }
  this->Plate->GetPointData()->AddArray(height);
  vtkNew<vtkIntArray> remark;
  remark->SetName("Remark");
  remark->InsertNextValue(42);
  this->Plate->GetFieldData()->AddArray(remark);
  this->Filter->Update();
  vtkUnstructuredGrid* output = this->Filter->GetOutput();
  auto* carried = output->GetPointData()->GetArray("Height");
  ASSERT_TRUE(carried);
  const double thickest = 1e-4 * 17;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(carried->GetTuple1(i), output->GetPoint(i)[2], thickest);
  }
  EXPECT_TRUE(output->GetFieldData()->GetArray("Remark"));
  EXPECT_TRUE(output->GetFieldData()->GetArray(contract::LayersFirstHeight));
  EXPECT_TRUE(output->GetFieldData()->GetAbstractArray(contract::PatchNames));
}

TEST_F(DirectionalEnrichment, UsesWhatTheRemovalWasTold)
{
  vtkNew<vtkRANSPointRemoval> removal;
  removal->SetInputData(this->Plate);
  removal->SetFirstHeight(2e-4);
  removal->SetNumberOfLayers(5);
  vtkNew<vtkDirectionalEnrichment> enrichment;
  enrichment->SetInputConnection(removal->GetOutputPort());
  enrichment->Update();
  EXPECT_EQ(enrichment->GetNumberOfInsertedPoints(), 6 * 5 * 5);
  auto* first = enrichment->GetOutput()->GetFieldData()->GetArray(contract::LayersFirstHeight);
  EXPECT_EQ(first->GetTuple1(ZLow), 2e-4);
  enrichment->SetNumberOfLayers(7); // told otherwise
  enrichment->Update();
  EXPECT_EQ(enrichment->GetNumberOfInsertedPoints(), 6 * 5 * 7);
}

TEST_F(DirectionalEnrichment, TotalThicknessGivesTheNumberOfLayers)
{
  this->Filter->SetTotalThickness(1e-4 * (1 + 1.2 + 1.44 + 1.728));
  this->Filter->Update();
  EXPECT_EQ(this->Filter->GetNumberOfInsertedPoints(), 6 * 5 * 4);
}

TEST_F(DirectionalEnrichment, PatchesMayHaveLayersOfTheirOwn)
{
  this->Filter->SetPatchLayers("plate", 1e-3, 1.1, 3);
  this->Filter->Update();
  EXPECT_EQ(this->Filter->GetNumberOfInsertedPoints(), 6 * 5 * 3);
}

TEST_F(DirectionalEnrichment, GivesTheSameMeshTwice)
{
  this->Filter->Update();
  const ransmesh::MeshData first = Read(this->Filter->GetOutput());
  this->Filter->Modified();
  this->Filter->Update();
  const ransmesh::MeshData second = Read(this->Filter->GetOutput());
  EXPECT_EQ(first.points, second.points);
  EXPECT_EQ(first.tetrahedra, second.tetrahedra);
  EXPECT_EQ(first.triangles, second.triangles);
}

TEST_F(DirectionalEnrichment, StopsWhenTheUserAborts)
{
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  this->Filter->AddObserver(vtkCommand::ProgressEvent, abort);
  ErrorCatcher errors(this->Filter);
  this->Filter->Update();
  EXPECT_EQ(errors.GetText(), "");
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfCells(), 0);
}

TEST_F(DirectionalEnrichment, RefusesAFirstHeightThatIsNotPositive)
{
  this->Filter->SetFirstHeight(0);
  this->ExpectRefusal("set FirstHeight");
  this->Filter->SetFirstHeight(-1e-3);
  this->ExpectRefusal("it must be positive");
}

TEST_F(DirectionalEnrichment, RefusesAFirstHeightLargerThanTheMesh)
{
  this->Filter->SetFirstHeight(3);
  this->ExpectRefusal("is not below the largest extent of the mesh");
}

TEST_F(DirectionalEnrichment, RefusesAGrowthRateBelowOne)
{
  this->Filter->SetGrowthRate(0.9);
  this->ExpectRefusal("growth rate");
}

TEST_F(DirectionalEnrichment, RefusesAnImpossibleNumberOfLayers)
{
  this->Filter->SetNumberOfLayers(0);
  this->ExpectRefusal("number of layers");
}

TEST_F(DirectionalEnrichment, RefusesAGapFractionOutOfRange)
{
  this->Filter->SetGapFraction(0.7);
  this->ExpectRefusal("gap fraction");
}

TEST_F(DirectionalEnrichment, RefusesWallsThatAreNotThere)
{
  this->Filter->AddWallPatch("fuselage*");
  this->ExpectRefusal("no patch is taken by the wall pattern \"fuselage*\"; the patches are: x_low");
}

TEST_F(DirectionalEnrichment, RefusesAMeshWithoutWalls)
{
  auto* types =
    vtkStringArray::SafeDownCast(this->Plate->GetFieldData()->GetAbstractArray(contract::PatchTypes));
  types->SetValue(ZLow, "farfield");
  this->Plate->Modified();
  this->ExpectRefusal("name the walls with AddWallPatch");
}

TEST_F(DirectionalEnrichment, RefusesHexahedra)
{
  vtkNew<vtkUnstructuredGrid> cube;
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint((i == 1 || i == 2 || i == 5 || i == 6), (i & 2) / 2, i / 4);
  }
  cube->SetPoints(points);
  const vtkIdType ids[8] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  cube->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
  this->Filter->SetInputData(cube);
  this->ExpectRefusal("vtkDataSetTriangleFilter");
}

TEST_F(DirectionalEnrichment, RefusesAnEmptyInput)
{
  vtkNew<vtkUnstructuredGrid> empty;
  this->Filter->SetInputData(empty);
  this->ExpectRefusal("the input is empty");
}

TEST_F(DirectionalEnrichment, RefusesAMeshThatIsNotValid)
{
  this->Plate->GetPoints()->SetPoint(70, 0.9, 0.9, 0.9);
  this->Plate->Modified();
  this->ExpectRefusal("tetrahedra not positive");
}

TEST_F(DirectionalEnrichment, RefusesCoordinatesThatAreNotFinite)
{
  this->Plate->GetPoints()->SetPoint(70, std::nan(""), 0, 0);
  this->Plate->Modified();
  this->ExpectRefusal("not finite");
}

// Scripts make arrays of any length.
TEST_F(DirectionalEnrichment, RefusesArraysThatAreTooShort)
{
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  height->InsertNextValue(1);
  this->Plate->GetPointData()->AddArray(height);
  this->ExpectRefusal("the point array Height has 1 values for 150 points");
  this->Plate->GetPointData()->RemoveArray("Height");
  vtkNew<vtkIntArray> patch;
  patch->SetName(contract::PatchId);
  this->Plate->GetCellData()->AddArray(patch);
  this->ExpectRefusal("the cell array PatchId has 0 values for ");
}

TEST_F(DirectionalEnrichment, RefusesATotalThicknessThatIsNone)
{
  for (const double bad : { -1.0, std::numeric_limits<double>::infinity(), std::nan("") })
  {
    this->Filter->SetTotalThickness(bad);
    this->ExpectRefusal("set TotalThickness");
  }
}

TEST_F(DirectionalEnrichment, RefusesARecordThatIsNoNumberOfLayers)
{
  vtkNew<vtkRANSPointRemoval> removal;
  removal->SetInputData(this->Plate);
  removal->SetFirstHeight(1e-4);
  removal->Update();
  for (const double bad : { -3.0, 1e30, std::nan("") })
  {
    vtkNew<vtkUnstructuredGrid> cleared;
    cleared->ShallowCopy(removal->GetOutput());
    vtkNew<vtkDoubleArray> number;
    number->SetName(contract::LayersNumber);
    number->SetNumberOfValues(cleared->GetFieldData()->GetArray(contract::LayersNumber)->GetNumberOfTuples());
    number->Fill(0);
    number->SetValue(ZLow, bad);
    cleared->GetFieldData()->AddArray(number);
    this->Filter->SetFirstHeight(0);
    this->Filter->SetNumberOfLayers(25);
    this->Filter->SetInputData(cleared);
    this->ExpectRefusal("set NumberOfLayers");
  }
}

// Far above what can be: the layers end where they meet the isotropic mesh.
TEST_F(DirectionalEnrichment, AnyHeightsGiveAValidMesh)
{
  struct Heights
  {
    double first;
    double growth;
    int layers;
  };
  constexpr Heights all[] = { { 1e-12, 1.2, 200 }, { 1e-12, 10, 1000 }, { 1e-3, 1, 1000 }, { 2e-15, 1.2, 25 },
    { 0.3, 1.2, 1 }, { 0.9, 10, 1000 } };
  for (const Heights& heights : all)
  {
    this->Filter->SetFirstHeight(heights.first);
    this->Filter->SetGrowthRate(heights.growth);
    this->Filter->SetNumberOfLayers(heights.layers);
    ErrorCatcher errors(this->Filter);
    this->Filter->Update();
    EXPECT_EQ(errors.GetText(), "");
    const auto faults = ransmesh::findFaults(Read(this->Filter->GetOutput()));
    EXPECT_TRUE(faults.none()) << heights.first << ": " << faults.text();
  }
}

TEST_F(DirectionalEnrichment, SaysWhyThereAreNoLayers)
{
  WarningCatcher warnings(this->Filter);
  this->Filter->SetFirstHeight(0.9);
  this->Filter->Update();
  EXPECT_EQ(this->Filter->GetNumberOfInsertedPoints(), 0);
  EXPECT_TRUE(warnings.Says("no layers were made; wall points by StopReason: isotropic size reached 30"))
    << warnings.GetText();
}

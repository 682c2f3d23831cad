#include "vtkRANSPointRemoval.h"

#include "ErrorCatcher.h"
#include "MeshConversion.h"
#include "Support/GridMesh.h"

#include "Mesh/Validation.h"
#include "Support/DataContract.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkIsotropicTetMesher.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

namespace
{
namespace contract = ransmesh::contract;
using grid_mesh::ZLow;

constexpr double Thickness = 0.2;

class PointRemovalFilter : public testing::Test
{
protected:
  void SetUp() override
  {
    ransmesh::PatchTable table = grid_mesh::patches(ransmesh::PatchType::Symmetry);
    table[ZLow] = { "plate", ransmesh::PatchType::Wall };
    ransmesh::writeMesh(grid_mesh::make({ 8, 8, 8, {}, 0.1 }), table, this->Plate);
    this->Filter->SetInputData(this->Plate);
    this->Filter->SetFirstHeight(Thickness / 10);
    this->Filter->SetGrowthRate(1);
    this->Filter->SetNumberOfLayers(10);
  }

  ransmesh::MeshData Read(vtkUnstructuredGrid* grid)
  {
    ransmesh::MeshData mesh;
    ransmesh::PatchTable patches;
    EXPECT_TRUE(ransmesh::readMesh(grid, mesh, patches).ok());
    return mesh;
  }

  void ExpectRefusal(const char* phrase)
  {
    ErrorCatcher errors(this->Filter);
    this->Filter->Update();
    EXPECT_TRUE(errors.Says(phrase)) << errors.GetText();
    EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfCells(), 0);
  }

  // A copy of the plate with one value of a kind that it should not have.
  void GivePoint(vtkIdType i, double x, double y, double z)
  {
    this->Plate->GetPoints()->SetPoint(i, x, y, z);
    this->Plate->Modified();
  }

  vtkNew<vtkUnstructuredGrid> Plate;
  vtkNew<vtkRANSPointRemoval> Filter;
};
} // namespace

TEST_F(PointRemovalFilter, EmptiesTheRegionAndGivesAValidMesh)
{
  ErrorCatcher errors(this->Filter);
  this->Filter->Update();
  EXPECT_EQ(errors.GetText(), "");
  vtkUnstructuredGrid* output = this->Filter->GetOutput();
  const auto faults = ransmesh::findFaults(this->Read(output));
  EXPECT_TRUE(faults.none()) << faults.text();
  EXPECT_GT(this->Filter->GetNumberOfMarkedPoints(), 100);
  EXPECT_GE(this->Filter->GetNumberOfRemovedPoints(), this->Filter->GetNumberOfMarkedPoints() - 1);
  EXPECT_EQ(this->Filter->GetNumberOfShapePoints(), 0);
  EXPECT_EQ(
    this->Plate->GetNumberOfPoints() - output->GetNumberOfPoints(), this->Filter->GetNumberOfRemovedPoints());
  auto* patch = vtkIntArray::SafeDownCast(output->GetCellData()->GetArray(contract::PatchId));
  ASSERT_TRUE(patch);
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    EXPECT_EQ(output->GetCellType(c) == VTK_TETRA, patch->GetValue(c) == 0);
  }
}

TEST_F(PointRemovalFilter, TakesTheFirstHeightFromTheFlow)
{
  this->Filter->SetVelocity(50);
  this->Filter->SetReferenceLength(1);
  EXPECT_NEAR(this->Filter->GetEstimatedFirstHeight() / 7.4869996e-6, 1, 1e-6);
  EXPECT_NEAR(this->Filter->GetEstimatedReynoldsNumber(), 3422935, 1);
  EXPECT_NEAR(this->Filter->GetEstimatedSkinFriction(), 3.0452087e-3, 1e-9);
  EXPECT_NEAR(this->Filter->GetEstimatedFrictionVelocity(), 1.9510282, 1e-6);
  EXPECT_NEAR(this->Filter->GetEstimatedBoundaryLayerThickness(), 0.01825248, 1e-7);
  EXPECT_NEAR(this->Filter->GetPlannedTotalThickness() / 7.4869996e-5, 1, 1e-6);
  this->Filter->SetThicknessFromFlow(true);
  this->Filter->SetGrowthRate(1.2);
  EXPECT_NEAR(this->Filter->GetPlannedTotalThickness() / 0.01825248, 1, 0.1);
  this->Filter->Update();
  auto* recorded = vtkDoubleArray::SafeDownCast(
    this->Filter->GetOutput()->GetFieldData()->GetArray(contract::LayersFirstHeight));
  ASSERT_TRUE(recorded);
  EXPECT_DOUBLE_EQ(recorded->GetValue(ZLow), this->Filter->GetEstimatedFirstHeight());
}

TEST_F(PointRemovalFilter, RefusesImpossibleFlowConditions)
{
  this->Filter->SetThicknessFromFlow(true);
  this->ExpectRefusal("ThicknessFromFlow needs flow conditions");
  this->Filter->SetVelocity(50);
  this->ExpectRefusal("set ReferenceLength");
  this->Filter->SetReferenceLength(1);
  this->Filter->SetFluid(vtkRANSLayerAlgorithm::CUSTOM_FLUID);
  this->Filter->SetViscosity(-1);
  this->ExpectRefusal("set Viscosity");
  EXPECT_EQ(this->Filter->GetEstimatedFirstHeight(), 0);
}

TEST_F(PointRemovalFilter, DoesNothingForThinLayers)
{
  this->Filter->SetFirstHeight(1e-6);
  this->Filter->Update();
  EXPECT_EQ(this->Filter->GetNumberOfMarkedPoints(), 0);
  EXPECT_EQ(this->Read(this->Filter->GetOutput()).tetrahedra, this->Read(this->Plate).tetrahedra);
}

TEST_F(PointRemovalFilter, KeepsPointDataWhereThePointsAre)
{
  vtkNew<vtkDoubleArray> number;
  number->SetName("Number");
  for (vtkIdType i = 0; i < this->Plate->GetNumberOfPoints(); ++i)
  {
    number->InsertNextValue(static_cast<double>(i));
  }
  this->Plate->GetPointData()->AddArray(number);
  this->Filter->Update();
  vtkUnstructuredGrid* output = this->Filter->GetOutput();
  auto* kept = output->GetPointData()->GetArray("Number");
  ASSERT_TRUE(kept);
  ASSERT_EQ(kept->GetNumberOfTuples(), output->GetNumberOfPoints());
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double now[3];
    double then[3];
    output->GetPoint(i, now);
    this->Plate->GetPoint(static_cast<vtkIdType>(kept->GetTuple1(i)), then);
    if (now[2] == 0 || now[2] > 2 * Thickness) // points between may have been moved
    {
      EXPECT_EQ(now[0], then[0]);
      EXPECT_EQ(now[1], then[1]);
      EXPECT_EQ(now[2], then[2]);
    }
  }
}

TEST_F(PointRemovalFilter, PassesFieldDataAndRecordsTheLayers)
{
  vtkNew<vtkIntArray> remark;
  remark->SetName("Remark");
  remark->InsertNextValue(42);
  this->Plate->GetFieldData()->AddArray(remark);
  this->Filter->Update();
  vtkFieldData* fieldData = this->Filter->GetOutput()->GetFieldData();
  EXPECT_TRUE(fieldData->GetArray("Remark"));
  EXPECT_TRUE(fieldData->GetAbstractArray(contract::PatchNames));
  auto* layers = fieldData->GetArray(contract::LayersNumber);
  ASSERT_TRUE(layers);
  EXPECT_EQ(layers->GetTuple1(ZLow), 10);
  EXPECT_EQ(layers->GetTuple1(ZLow + 1), 0);
}

TEST_F(PointRemovalFilter, GivesTheSameMeshTwice)
{
  this->Filter->Update();
  const ransmesh::MeshData first = this->Read(this->Filter->GetOutput());
  this->Filter->Modified();
  this->Filter->Update();
  const ransmesh::MeshData second = this->Read(this->Filter->GetOutput());
  EXPECT_EQ(first.points, second.points);
  EXPECT_EQ(first.tetrahedra, second.tetrahedra);
}

TEST_F(PointRemovalFilter, RunsOnItsOwnOutput)
{
  this->Filter->Update();
  vtkNew<vtkRANSPointRemoval> again;
  again->SetInputConnection(this->Filter->GetOutputPort());
  ErrorCatcher errors(again);
  again->Update();
  EXPECT_EQ(errors.GetText(), "");
  EXPECT_LE(again->GetNumberOfMarkedPoints(), 1);
}

TEST_F(PointRemovalFilter, EmptiesTheSpaceAroundABodyThatTheMesherMeshed)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(24);
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->SetInputConnection(sphere->GetOutputPort());
  mesher->SetFarField(true);
  for (const double thickness : { 0.05, 0.1, 0.2 }) // edges are about 0.07
  {
    vtkNew<vtkRANSPointRemoval> removal;
    removal->SetInputConnection(mesher->GetOutputPort());
    removal->SetFirstHeight(1e-4);
    removal->SetTotalThickness(thickness);
    removal->SetIsotropicFraction(10);
    ErrorCatcher errors(removal);
    removal->Update();
    EXPECT_EQ(errors.GetText(), "");
    const vtkIdType marked = removal->GetNumberOfMarkedPoints();
    EXPECT_GT(marked, 0);
    EXPECT_LE(marked - removal->GetNumberOfRemovedPoints(), marked / 200) << "thickness " << thickness;
    const auto faults = ransmesh::findFaults(this->Read(removal->GetOutput()));
    EXPECT_TRUE(faults.none()) << faults.text();
  }
}

TEST_F(PointRemovalFilter, RefusesAnEmptyInput)
{
  vtkNew<vtkUnstructuredGrid> nothing;
  this->Filter->SetInputData(nothing);
  this->ExpectRefusal("empty");
}

TEST_F(PointRemovalFilter, RefusesHexahedra)
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(i & 1, i >> 1 & 1, i >> 2);
  }
  grid->SetPoints(points);
  const vtkIdType corners[8] = { 0, 1, 3, 2, 4, 5, 7, 6 };
  grid->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
  this->Filter->SetInputData(grid);
  this->ExpectRefusal("VTK type 12");
}

TEST_F(PointRemovalFilter, RefusesCoordinatesThatAreNotFinite)
{
  this->GivePoint(100, vtkMath::Nan(), 0, 0);
  this->ExpectRefusal("not finite");
}

TEST_F(PointRemovalFilter, RefusesAFoldedMesh)
{
  this->GivePoint(4 * 81 + 4 * 9 + 4, 0.9, 0.9, 0.9); // from the middle to a corner
  this->ExpectRefusal("not positive");
}

TEST_F(PointRemovalFilter, RefusesImpossibleLayers)
{
  this->Filter->SetFirstHeight(0);
  this->ExpectRefusal("FirstHeight");
  this->Filter->SetFirstHeight(-1);
  this->ExpectRefusal("first height");
  this->Filter->SetFirstHeight(5);
  this->ExpectRefusal("extent");
  this->Filter->SetFirstHeight(1e-3);
  this->Filter->SetGrowthRate(0.5);
  this->ExpectRefusal("growth rate");
}

TEST_F(PointRemovalFilter, RefusesWallsThatAreNotThere)
{
  this->Filter->AddWallPatch("wing");
  this->ExpectRefusal("wing");
}

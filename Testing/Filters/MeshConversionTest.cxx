#include "MeshConversion.h"

#include "../Kernel/Support/LayeredBox.h"

#include "Mesh/Validation.h"
#include "Support/DataContract.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCharArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkLongLongArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkShortArray.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

namespace
{
using namespace ransmesh;

MeshData Box()
{
  return layered_box::make(3, 2, 0.5, { 0, 0.1, 0.3, 1 });
}

vtkSmartPointer<vtkUnstructuredGrid> GridOf(const MeshData& mesh)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  writeMesh(mesh, layered_box::patches(), grid);
  return grid;
}

// What readMesh says about a grid; empty when it reads it.
std::string MessageFor(vtkUnstructuredGrid* grid)
{
  MeshData mesh;
  PatchTable patches;
  const Outcome outcome = readMesh(grid, mesh, patches);
  EXPECT_EQ(outcome.ok(), outcome.message.empty());
  return outcome.message;
}

bool Contains(const std::string& text, const char* phrase)
{
  return text.find(phrase) != std::string::npos;
}

template <class Array>
void ReplacePatchIds(vtkUnstructuredGrid* grid)
{
  vtkDataArray* old = grid->GetCellData()->GetArray(contract::PatchId);
  vtkNew<Array> array;
  array->SetName(contract::PatchId);
  array->SetNumberOfTuples(old->GetNumberOfTuples());
  for (vtkIdType i = 0; i < old->GetNumberOfTuples(); ++i)
  {
    array->SetTuple1(i, old->GetTuple1(i));
  }
  grid->GetCellData()->AddArray(array);
}

TEST(MeshConversion, roundTripChangesNothing)
{
  const MeshData mesh = Box();
  const auto grid = GridOf(mesh);
  EXPECT_EQ(grid->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(grid->GetCellType(0), VTK_TETRA);
  EXPECT_EQ(grid->GetCellType(grid->GetNumberOfCells() - 1), VTK_TRIANGLE);
  MeshData back;
  PatchTable patches;
  ASSERT_TRUE(readMesh(grid, back, patches).ok());
  EXPECT_EQ(back.points, mesh.points);
  EXPECT_EQ(back.tetrahedra, mesh.tetrahedra);
  EXPECT_EQ(back.triangles, mesh.triangles);
  EXPECT_EQ(back.trianglePatch, mesh.trianglePatch);
  ASSERT_EQ(patches.size(), layered_box::patches().size());
  for (std::size_t i = 0; i < patches.size(); ++i)
  {
    EXPECT_EQ(patches[i].name, layered_box::patches()[i].name);
    EXPECT_EQ(patches[i].type, layered_box::patches()[i].type);
  }
  EXPECT_TRUE(findFaults(back).none()) << findFaults(back).text();
}

TEST(MeshConversion, planRoundTrip)
{
  LayerPlan plan(3);
  plan[1].firstHeight = 1e-7;
  plan[1].growthRate = 1.3;
  plan[1].numberOfLayers = 17;
  plan[1].constantLayers = 2;
  plan[1].isotropicFraction = 0.5;
  plan[1].normalAngle = 40;
  plan[1].fanAngle = 15;
  vtkNew<vtkUnstructuredGrid> grid;
  EXPECT_TRUE(readPlan(grid->GetFieldData()).empty());
  writePlan(plan, grid->GetFieldData());
  const LayerPlan back = readPlan(grid->GetFieldData());
  ASSERT_EQ(back.size(), 3u);
  EXPECT_FALSE(back[0].hasLayers());
  EXPECT_EQ(back[1].firstHeight, 1e-7);
  EXPECT_EQ(back[1].growthRate, 1.3);
  EXPECT_EQ(back[1].numberOfLayers, 17);
  EXPECT_EQ(back[1].constantLayers, 2);
  EXPECT_EQ(back[1].isotropicFraction, 0.5);
  EXPECT_EQ(back[1].normalAngle, 40);
  EXPECT_EQ(back[1].fanAngle, 15);
}

TEST(MeshConversion, refusesAnEmptyGrid)
{
  vtkNew<vtkUnstructuredGrid> grid;
  EXPECT_TRUE(Contains(MessageFor(grid), "empty"));
  EXPECT_TRUE(Contains(MessageFor(nullptr), "empty"));
}

TEST(MeshConversion, refusesOtherCells)
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
  const std::string message = MessageFor(grid);
  EXPECT_TRUE(Contains(message, "cell 0 is of VTK type 12")) << message;
  EXPECT_TRUE(Contains(message, "vtkDataSetTriangleFilter")) << message;
}

TEST(MeshConversion, refusesSurfacesAlone)
{
  MeshData mesh = Box();
  mesh.tetrahedra.clear();
  EXPECT_TRUE(Contains(MessageFor(GridOf(mesh)), "no tetrahedra"));
}

TEST(MeshConversion, refusesAMeshWithoutPatches)
{
  const auto grid = GridOf(Box());
  grid->GetCellData()->RemoveArray(contract::PatchId);
  EXPECT_TRUE(Contains(MessageFor(grid), "PatchId"));
  MeshData noTriangles = Box();
  noTriangles.triangles.clear();
  noTriangles.trianglePatch.clear();
  EXPECT_TRUE(Contains(MessageFor(GridOf(noTriangles)), "no boundary triangles"));
}

TEST(MeshConversion, refusesPatchNumbersThatAreNone)
{
  for (const double bad : { 0.0, -3.0, 1.5, 100001.0, 1e9, 1e30, std::numeric_limits<double>::quiet_NaN() })
  {
    const auto grid = GridOf(Box());
    ReplacePatchIds<vtkDoubleArray>(grid);
    grid->GetCellData()->GetArray(contract::PatchId)->SetTuple1(grid->GetNumberOfCells() - 2, bad);
    EXPECT_TRUE(Contains(MessageFor(grid), "has PatchId")) << bad << ": " << MessageFor(grid);
  }
}

TEST(MeshConversion, readsPatchNumbersOfAnyType)
{
  const MeshData mesh = Box();
  const auto check = [&mesh](vtkUnstructuredGrid* grid)
  {
    MeshData back;
    PatchTable patches;
    ASSERT_TRUE(readMesh(grid, back, patches).ok());
    EXPECT_EQ(back.trianglePatch, mesh.trianglePatch);
  };
  const auto grid = GridOf(mesh);
  ReplacePatchIds<vtkCharArray>(grid);
  check(grid);
  ReplacePatchIds<vtkUnsignedCharArray>(grid);
  check(grid);
  ReplacePatchIds<vtkShortArray>(grid);
  check(grid);
  ReplacePatchIds<vtkIntArray>(grid);
  check(grid);
  ReplacePatchIds<vtkLongLongArray>(grid);
  check(grid);
  ReplacePatchIds<vtkIdTypeArray>(grid);
  check(grid);
  ReplacePatchIds<vtkFloatArray>(grid);
  check(grid);
}

TEST(MeshConversion, turnsTrianglesOutward)
{
  MeshData mesh = Box();
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
  {
    std::swap(mesh.triangles[i][0], mesh.triangles[i][1]);
  }
  ASSERT_GT(findFaults(mesh).trianglesTurnedInward, 0u);
  MeshData back;
  PatchTable patches;
  ASSERT_TRUE(readMesh(GridOf(mesh), back, patches).ok());
  EXPECT_TRUE(findFaults(back).none()) << findFaults(back).text();
}

TEST(MeshConversion, namesPatchesThatHaveNone)
{
  const auto grid = GridOf(Box());
  grid->GetFieldData()->RemoveArray(contract::PatchNames);
  grid->GetFieldData()->RemoveArray(contract::PatchTypes);
  MeshData mesh;
  PatchTable patches;
  ASSERT_TRUE(readMesh(grid, mesh, patches).ok());
  ASSERT_EQ(patches.size(), 7u);
  EXPECT_EQ(patches[6].name, "patch_6");
  EXPECT_EQ(patches[6].type, PatchType::Patch);
}

TEST(MeshConversion, unknownPatchTypesBecomePatch)
{
  const auto grid = GridOf(Box());
  vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray(contract::PatchTypes))
    ->SetValue(layered_box::Floor, "ceiling");
  MeshData mesh;
  PatchTable patches;
  ASSERT_TRUE(readMesh(grid, mesh, patches).ok());
  EXPECT_EQ(patches[layered_box::Floor].type, PatchType::Patch);
  EXPECT_EQ(patches[layered_box::Lid].type, PatchType::FarField);
}

TEST(MeshConversion, readsCellsInAnyOrderAndPointsInFloat)
{
  const MeshData mesh = Box();
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  for (const auto& p : mesh.points)
  {
    points->InsertNextPoint(p.x, p.y, p.z);
  }
  grid->SetPoints(points);
  vtkNew<vtkIntArray> patchIds;
  patchIds->SetName(contract::PatchId);
  std::size_t triangle = 0;
  for (const auto& t : mesh.tetrahedra) // a triangle after each tetrahedron, while there are any
  {
    const vtkIdType corners[4] = { t[0], t[1], t[2], t[3] };
    grid->InsertNextCell(VTK_TETRA, 4, corners);
    patchIds->InsertNextValue(0);
    if (triangle < mesh.triangles.size())
    {
      const auto& f = mesh.triangles[triangle];
      const vtkIdType face[3] = { f[0], f[1], f[2] };
      grid->InsertNextCell(VTK_TRIANGLE, 3, face);
      patchIds->InsertNextValue(mesh.trianglePatch[triangle++]);
    }
  }
  ASSERT_EQ(triangle, mesh.triangles.size());
  grid->GetCellData()->AddArray(patchIds);
  MeshData back;
  PatchTable patches;
  ASSERT_TRUE(readMesh(grid, back, patches).ok());
  EXPECT_EQ(back.tetrahedra, mesh.tetrahedra);
  EXPECT_EQ(back.trianglePatch, mesh.trianglePatch);
  EXPECT_TRUE(findFaults(back).none()) << findFaults(back).text();
}

TEST(MeshConversion, pointNumbersOutOfRangeAreForTheKernelToReport)
{
  MeshData mesh = Box();
  mesh.tetrahedra[3][1] = 100000;
  MeshData back;
  PatchTable patches;
  ASSERT_TRUE(readMesh(GridOf(mesh), back, patches).ok());
  EXPECT_EQ(findFaults(back).indicesOutOfRange, 1u);
}
} // namespace

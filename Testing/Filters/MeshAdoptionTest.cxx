// Meshes that other programs made: read, adopted, enriched.
#include "ErrorCatcher.h"

#include "MeshConversion.h"
#include "vtkDirectionalEnrichment.h"
#include "vtkGmshMeshReader.h"
#include "vtkMeshAdoption.h"
#include "vtkRANSPointRemoval.h"

#include "Mesh/Validation.h"
#include "Support/DataContract.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace
{
std::string fileOf(const std::string& name)
{
  return std::string(RANSMESHING_TEST_MESHES) + "/" + name;
}

// A mesh by the contract; the test fails where it is not valid.
struct Contents
{
  ransmesh::MeshData mesh;
  ransmesh::PatchTable patches;
  std::map<std::string, int> trianglesOf;

  explicit Contents(vtkUnstructuredGrid* grid)
  {
    const ransmesh::Outcome outcome = ransmesh::readMesh(grid, mesh, patches);
    EXPECT_TRUE(outcome.ok()) << outcome.message;
    const ransmesh::MeshFaults faults = ransmesh::findFaults(mesh);
    EXPECT_TRUE(faults.none()) << faults.text();
    for (const int patch : mesh.trianglePatch)
    {
      ++trianglesOf[patches.at(patch).name];
    }
  }
};

Contents adopted(vtkDataObject* data)
{
  vtkNew<vtkMeshAdoption> adoption;
  ErrorCatcher errors(adoption);
  adoption->SetInputDataObject(data);
  adoption->Update();
  EXPECT_EQ(errors.GetText(), "");
  return Contents(adoption->GetOutput());
}

std::string refusal(vtkDataObject* data)
{
  vtkNew<vtkMeshAdoption> adoption;
  ErrorCatcher errors(adoption);
  adoption->SetInputDataObject(data);
  adoption->Update();
  return errors.GetText();
}

vtkSmartPointer<vtkUnstructuredGrid> readFile(const std::string& path)
{
  vtkNew<vtkGmshMeshReader> reader;
  ErrorCatcher errors(reader);
  reader->SetFileName(path.c_str());
  reader->Update();
  EXPECT_EQ(errors.GetText(), "");
  return reader->GetOutput();
}

// Two tetrahedra on one side of which each lies a triangle, numbered by `numbers`.
vtkSmartPointer<vtkUnstructuredGrid> pair(const char* array, const std::vector<int>& numbers)
{
  const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  for (const auto& x : { std::array{ 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 },
         { 0.0, 0.0, -1.0 }, { 5.0, 5.0, 5.0 } })
  {
    points->InsertNextPoint(x.data());
  }
  grid->SetPoints(points);
  const vtkIdType cells[][4] = { { 0, 1, 2, 3 }, { 0, 1, 2, 4 } }; // the second is turned over
  grid->InsertNextCell(VTK_TETRA, 4, cells[0]);
  grid->InsertNextCell(VTK_TETRA, 4, cells[1]);
  const vtkIdType triangles[][3] = { { 0, 1, 3 }, { 0, 1, 4 }, { 0, 1, 2 } }; // the last lies inside
  vtkNew<vtkIntArray> ids;
  ids->SetName(array);
  ids->InsertNextValue(100);
  ids->InsertNextValue(100);
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    grid->InsertNextCell(VTK_TRIANGLE, 3, triangles[i]);
    ids->InsertNextValue(numbers[i]);
  }
  grid->GetCellData()->AddArray(ids);
  return grid;
}
} // namespace

class GmshFiles : public testing::TestWithParam<const char*>
{
};

TEST_P(GmshFiles, KeepTheirPatches)
{
  const Contents contents = adopted(readFile(fileOf(GetParam())));
  EXPECT_EQ(contents.trianglesOf.size(), 4u);
  EXPECT_GT(contents.trianglesOf.at("ball wall"), 10);
  EXPECT_GT(contents.trianglesOf.at("symmetry sides"), 10);
  for (const ransmesh::Patch& patch : contents.patches)
  {
    const std::map<std::string, ransmesh::PatchType> expected = { { "ball wall", ransmesh::PatchType::Wall },
      { "inlet", ransmesh::PatchType::Inlet }, { "outlet", ransmesh::PatchType::Outlet },
      { "symmetry sides", ransmesh::PatchType::Symmetry } };
    EXPECT_TRUE(patch.name == "fluid" || expected.at(patch.name) == patch.type) << patch.name;
  }
  EXPECT_NEAR(ransmesh::totalVolume(contents.mesh), 16 - 0.4, 0.2);
}

TEST_P(GmshFiles, GetLayers)
{
  vtkNew<vtkGmshMeshReader> reader;
  reader->SetFileName(fileOf(GetParam()).c_str());
  vtkNew<vtkMeshAdoption> adoption;
  adoption->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkRANSPointRemoval> removal;
  removal->SetInputConnection(adoption->GetOutputPort());
  removal->SetFirstHeight(1e-3);
  removal->SetNumberOfLayers(10);
  vtkNew<vtkDirectionalEnrichment> enrichment;
  enrichment->SetInputConnection(removal->GetOutputPort());
  ErrorCatcher errors(enrichment);
  enrichment->Update();
  EXPECT_EQ(errors.GetText(), "");
  const Contents contents(enrichment->GetOutput());
  EXPECT_GT(contents.mesh.tetrahedra.size(), 1500u);
}

INSTANTIATE_TEST_SUITE_P(MeshAdoption, GmshFiles,
  testing::Values("ball-22.msh", "ball-22-binary.msh", "ball-41.msh", "ball-41-binary.msh"),
  [](const auto& file)
  {
    std::string name = file.param;
    name = name.substr(5, name.find('.') - 5);
    return name.size() > 2 ? name.substr(0, 2) + "Binary" : name + "Text";
  });

TEST(MeshAdoption, TakesMeshesOfNetgen)
{
  vtkNew<vtkMeshAdoption> adoption;
  adoption->SetInputDataObject(readFile(fileOf("ball-netgen.msh")));
  adoption->SetPatchType("patch_7", "wall");
  ErrorCatcher errors(adoption);
  adoption->Update();
  EXPECT_EQ(errors.GetText(), "");
  const Contents contents(adoption->GetOutput());
  EXPECT_EQ(contents.trianglesOf.size(), 7u); // six sides and the ball
  EXPECT_NEAR(ransmesh::totalVolume(contents.mesh), 16 - 0.5, 0.1);
}

TEST(MeshAdoption, SaysWhatFilesItCannotRead)
{
  const std::string path = testing::TempDir() + "adoption-test.msh";
  const auto tells = [&path](const std::string& content, const char* message)
  {
    std::ofstream(path, std::ios::binary) << content;
    vtkNew<vtkGmshMeshReader> reader;
    ErrorCatcher errors(reader);
    reader->SetFileName(path.c_str());
    reader->Update();
    EXPECT_NE(errors.GetText().find(message), std::string::npos) << errors.GetText();
  };
  tells("", "it holds no mesh");
  tells("words\n", "it holds no mesh");
  tells("$MeshFormat\n1 0 8\n$EndMeshFormat\n", "2.2 and 4.1 can be read");
  tells("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n2\n1 0 0", "a number is missing");
  std::ifstream file(fileOf("ball-41-binary.msh"), std::ios::binary);
  const std::string whole{ std::istreambuf_iterator<char>(file), {} };
  for (std::size_t length = 0; length < whole.size(); length += 997)
  {
    tells(whole.substr(0, length), "is no mesh of gmsh that can be read");
  }
  std::remove(path.c_str());
}

TEST(MeshAdoption, FindsPatchesByTheirAngles)
{
  const Contents contents = adopted(pair("nothing", {}));
  EXPECT_EQ(contents.trianglesOf.size(), 4u); // of six faces, two and two lie in planes
  EXPECT_EQ(contents.mesh.points.size(), 5u) << "the unused point goes";
}

TEST(MeshAdoption, KeepsTheNumbersOfOtherTools)
{
  for (const char* array : { "gmsh:physical", "CellEntityIds", "medit:ref", "netgen:index" })
  {
    const Contents contents = adopted(pair(array, { 3, 7 }));
    EXPECT_EQ(contents.trianglesOf.at("patch_3"), 1);
    EXPECT_EQ(contents.trianglesOf.at("patch_7"), 1);
    EXPECT_GE(contents.trianglesOf.size(), 4u);
  }
}

TEST(MeshAdoption, PartsTrianglesInsideFromThoseOutside)
{
  const Contents contents = adopted(pair("PatchId", { 3, 3, 3 }));
  EXPECT_EQ(contents.trianglesOf.at("patch_3"), 2);
  EXPECT_EQ(contents.trianglesOf.at("patch_3_inside"), 1);
}

TEST(MeshAdoption, TakesBlocks)
{
  const auto grid = pair("nothing", {});
  vtkNew<vtkPoints> points; // of its own
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(0, 0, 1);
  vtkNew<vtkPolyData> wall;
  wall->SetPoints(points);
  wall->AllocateEstimate(1, 3);
  const vtkIdType corners[] = { 0, 1, 2 };
  wall->InsertNextCell(VTK_TRIANGLE, 3, corners);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, grid);
  blocks->SetBlock(1, wall);
  blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "NoSlip_plate");
  const Contents contents = adopted(blocks);
  EXPECT_EQ(contents.trianglesOf.at("NoSlip_plate"), 1);
  EXPECT_EQ(contents.mesh.points.size(), 5u);
}

TEST(MeshAdoption, RefusesWhatIsNoMeshOfTetrahedra)
{
  const auto grid = pair("nothing", {});
  const vtkIdType hexahedron[] = { 0, 1, 2, 3, 0, 1, 2, 3 };
  grid->InsertNextCell(VTK_HEXAHEDRON, 8, hexahedron);
  EXPECT_NE(refusal(grid).find("is a vtkHexahedron"), std::string::npos);
  EXPECT_NE(refusal(vtkNew<vtkUnstructuredGrid>()).find("no tetrahedra"), std::string::npos);
  const auto flat = pair("nothing", {});
  const vtkIdType cell[] = { 0, 1, 2, 2 };
  flat->InsertNextCell(VTK_TETRA, 4, cell);
  EXPECT_NE(refusal(flat).find("has no volume"), std::string::npos);
  const auto overlapping = pair("nothing", {});
  const vtkIdType third[] = { 0, 1, 2, 5 };
  overlapping->InsertNextCell(VTK_TETRA, 4, third);
  EXPECT_NE(refusal(overlapping).find("the mesh is not valid"), std::string::npos);
}

// How vtkIsotropicTetMesher finds, numbers and names patches.
#include "MesherRun.h"
#include "TestSurfaces.h"

#include "Support/DataContract.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkStringArray.h"

TEST(IsotropicTetMesher, NamesPatchesByBlocks)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, TestSurfaces::Cube(-4, 4));
  blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "FarField");
  blocks->SetBlock(1, TestSurfaces::Sphere(1, 12));
  blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "hull");
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(blocks);
  mesher->SetPatchType("hu*", "wall");
  const MesherRun run(mesher);
  EXPECT_EQ(run.trianglesOf.size(), 2u);
  EXPECT_EQ(run.typeOf.at("FarField"), ransmesh::PatchType::FarField);
  EXPECT_EQ(run.typeOf.at("hull"), ransmesh::PatchType::Wall);
}

TEST(IsotropicTetMesher, TakesCollectionsOfPartitions)
{
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartition(0, 0, TestSurfaces::Sphere(1, 12));
  collection->SetPartition(0, 1, TestSurfaces::Sphere(1, 12, 3));
  collection->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "balls");
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(collection);
  mesher->FarFieldOn();
  const MesherRun run(mesher);
  EXPECT_EQ(run.trianglesOf.count("balls"), 1u);
  EXPECT_EQ(run.trianglesOf.size(), 7u);
}

TEST(IsotropicTetMesher, KeepsPatchNumbersAndNames)
{
  const auto cube = TestSurfaces::Cube(0, 1);
  vtkNew<vtkIntArray> patch;
  patch->SetName(ransmesh::contract::PatchId);
  for (int i = 0; i < 12; ++i)
  {
    patch->InsertNextValue(i < 6 ? 2 : 4);
  }
  cube->GetCellData()->AddArray(patch);
  vtkNew<vtkStringArray> names;
  names->SetName(ransmesh::contract::PatchNames);
  for (const char* name : { "fluid", "a", "sym_left", "b", "nose" })
  {
    names->InsertNextValue(name);
  }
  cube->GetFieldData()->AddArray(names);
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(cube);
  const MesherRun run(mesher);
  EXPECT_EQ(run.patches.at(2).name, "sym_left");
  EXPECT_EQ(run.patches.at(2).type, ransmesh::PatchType::Symmetry);
  EXPECT_EQ(run.patches.at(4).name, "nose");
  EXPECT_EQ(run.trianglesOf.at("nose"), 6);
}

TEST(IsotropicTetMesher, ReadsTheNumbersOfOtherTools)
{
  const auto cube = TestSurfaces::Cube(0, 1);
  vtkNew<vtkDoubleArray> groups;
  groups->SetName("GroupIds");
  for (int i = 0; i < 12; ++i)
  {
    groups->InsertNextValue(i / 4);
  }
  cube->GetCellData()->AddArray(groups);
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(cube);
  const MesherRun run(mesher);
  EXPECT_EQ(run.trianglesOf.size(), 3u);
  EXPECT_EQ(run.trianglesOf.at("patch_0"), 4);
}

TEST(IsotropicTetMesher, SplitsPatchesAtEdges)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputDataObject(TestSurfaces::Cube(0, 1));
  mesher->PatchFromFeatureAngleOn();
  const MesherRun run(mesher);
  EXPECT_EQ(run.trianglesOf.size(), 6u);
  EXPECT_EQ(run.trianglesOf.at("surface_6"), 2);
}

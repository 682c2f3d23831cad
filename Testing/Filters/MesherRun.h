// A run of vtkIsotropicTetMesher in a test.
#ifndef MesherRun_h
#define MesherRun_h

#include "ErrorCatcher.h"

#include "MeshConversion.h"
#include "vtkIsotropicTetMesher.h"

#include "Mesh/Validation.h"

#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

// Runs the mesher and reads its mesh back; the test fails where the mesh is not valid.
struct MesherRun
{
  ransmesh::MeshData mesh;
  ransmesh::PatchTable patches;
  std::map<std::string, int> trianglesOf;
  std::map<std::string, ransmesh::PatchType> typeOf;

  explicit MesherRun(vtkIsotropicTetMesher* mesher)
  {
    ErrorCatcher errors(mesher);
    mesher->Update();
    EXPECT_EQ(errors.GetText(), "");
    const ransmesh::Outcome outcome = ransmesh::readMesh(mesher->GetOutput(), mesh, patches);
    EXPECT_TRUE(outcome.ok()) << outcome.message;
    const ransmesh::MeshFaults faults = ransmesh::findFaults(mesh);
    EXPECT_TRUE(faults.none()) << faults.text();
    for (const int patch : mesh.trianglePatch)
    {
      ++trianglesOf[patches.at(patch).name];
    }
    for (std::size_t i = 1; i < patches.size(); ++i)
    {
      typeOf[patches[i].name] = patches[i].type;
    }
    EXPECT_TRUE(std::is_sorted(mesh.trianglePatch.begin(), mesh.trianglePatch.end()));
  }
};

#endif

#include "vtkSolverMeshWriter.h"

#include "ErrorCatcher.h"
#include "MeshConversion.h"
#include "Support/GridMesh.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace
{
namespace fs = std::filesystem;

// Files cannot grow beyond this, as on a disk that is full.
class FullDisk
{
public:
  explicit FullDisk(rlim_t bytes)
  {
    this->Handler = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &this->Before);
    const rlimit small{ bytes, this->Before.rlim_max };
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk()
  {
    setrlimit(RLIMIT_FSIZE, &this->Before);
    std::signal(SIGXFSZ, this->Handler);
  }
  FullDisk(const FullDisk&) = delete;
  void operator=(const FullDisk&) = delete;

private:
  rlimit Before{};
  void (*Handler)(int);
};

// A writer of each kind, in a folder of its own.
class SolverMeshWriters : public testing::TestWithParam<const char*>
{
protected:
  SolverMeshWriters()
  {
    fs::create_directories(this->Folder);
    vtkNew<vtkUnstructuredGrid> mesh;
    ransmesh::writeMesh(
      grid_mesh::make({ 8, 8, 8, {}, 0.1 }), grid_mesh::patches(ransmesh::PatchType::Wall), mesh);
    this->Writer = vtkSmartPointer<vtkSolverMeshWriter>::Take(
      vtkSolverMeshWriter::NewForFile((this->Folder / GetParam()).c_str()));
    this->Writer->SetInputData(mesh);
  }
  ~SolverMeshWriters() override { fs::remove_all(this->Folder); }

  // The message; empty where it was written.
  std::string Write()
  {
    const ErrorCatcher errors(this->Writer);
    const bool done = this->Writer->Write() == 1;
    EXPECT_EQ(done, errors.GetText().empty());
    return errors.GetText();
  }

  // All paths below the folder.
  std::set<fs::path> Listing() const
  {
    const fs::recursive_directory_iterator paths(this->Folder);
    return { begin(paths), end(paths) };
  }

  fs::path Folder = fs::temp_directory_path() / ("writers-" + std::to_string(getpid()));
  vtkSmartPointer<vtkSolverMeshWriter> Writer;
};
} // namespace

TEST_P(SolverMeshWriters, AFullDiskLeavesNothing)
{
  {
    const FullDisk disk(4096);
    EXPECT_NE(this->Write().find("could not be written"), std::string::npos);
  }
  EXPECT_TRUE(this->Listing().empty());
}

TEST_P(SolverMeshWriters, AFullDiskLeavesWhatWasThere)
{
  ASSERT_EQ(this->Write(), "");
  const std::set<fs::path> before = this->Listing();
  {
    const FullDisk disk(4096);
    EXPECT_NE(this->Write().find("could not be written"), std::string::npos);
  }
  EXPECT_EQ(this->Listing(), before);
}

TEST_P(SolverMeshWriters, AFolderOrAFileInTheWayStays)
{
  const fs::path target = this->Folder / GetParam();
  const bool isFolder = target.filename() == "polyMesh";
  if (isFolder)
  {
    std::ofstream(target) << "precious";
  }
  else
  {
    fs::create_directory(target);
  }
  EXPECT_NE(this->Write().find(isFolder ? "is a file" : "is a folder"), std::string::npos);
  EXPECT_EQ(this->Listing(), std::set<fs::path>{ target });
}

TEST_P(SolverMeshWriters, AMissingFolder)
{
  const std::string path = (this->Folder / "none" / GetParam()).string();
  this->Writer->SetFileName(path.c_str());
  if (std::string(GetParam()) == "polyMesh")
  {
    EXPECT_EQ(this->Write(), "") << "the folders above a polyMesh are made";
    return;
  }
  EXPECT_NE(this->Write().find("make the folder first"), std::string::npos);
  EXPECT_TRUE(this->Listing().empty());
}

INSTANTIATE_TEST_SUITE_P(Formats, SolverMeshWriters,
  testing::Values("mesh.su2", "mesh.ugrid", "mesh.b8.ugrid", "mesh.cgns", "mesh.msh", "polyMesh"),
  [](const testing::TestParamInfo<const char*>& tested)
  {
    std::string name = tested.param;
    std::erase(name, '.');
    return name;
  });

#include "MeshFile.h"

#include "Messages.h"

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkSolverMeshWriter.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <unistd.h>

namespace
{
// VTK's writers as they are, but for pointers that they forget to set, and free where writing fails (9.1: a crash where
// the disk is full).
class GridWriter : public vtkXMLUnstructuredGridWriter
{
public:
  static GridWriter* New();
  vtkTypeMacro(GridWriter, vtkXMLUnstructuredGridWriter);

protected:
  GridWriter()
  {
    this->NumberOfPointsPositions = nullptr;
    this->NumberOfCellsPositions = nullptr;
  }
};
vtkStandardNewMacro(GridWriter);

class SurfaceWriter : public vtkXMLPolyDataWriter
{
public:
  static SurfaceWriter* New();
  vtkTypeMacro(SurfaceWriter, vtkXMLPolyDataWriter);

protected:
  SurfaceWriter()
  {
    this->NumberOfPointsPositions = nullptr;
    this->NumberOfVertsPositions = this->NumberOfLinesPositions = nullptr;
    this->NumberOfStripsPositions = this->NumberOfPolysPositions = nullptr;
  }
};
vtkStandardNewMacro(SurfaceWriter);
} // namespace

namespace commandline
{
namespace
{
namespace fs = std::filesystem;

std::string temporaryNameFor(const std::string& path)
{
  const fs::path target(path);
  return (target.parent_path() / ("." + target.filename().string() + "." + std::to_string(getpid())))
    .string();
}

void writeThenRename(const std::string& path, const std::function<bool(const std::string&)>& write)
{
  const std::string temporary = temporaryNameFor(path);
  std::error_code error;
  if (write(temporary))
  {
    fs::rename(temporary, path, error);
    if (!error)
    {
      return;
    }
  }
  std::error_code ignored;
  fs::remove(temporary, ignored);
  throw std::runtime_error(
    path + ": could not be written" + (error ? ": " + error.message() : ": is the disk full?"));
}

template <typename Writer>
bool writeXml(vtkDataObject* data, const std::string& path)
{
  vtkNew<Writer> writer;
  writer->SetInputData(data);
  writer->SetFileName(path.c_str());
  writer->SetDataModeToBinary(); // some ParaViews cannot read the default, appended
  writer->SetHeaderTypeToUInt64();
  return writer->Write() == 1 && writer->GetErrorCode() == 0;
}

// Null where the name is not that of a solver's mesh.
vtkSmartPointer<vtkSolverMeshWriter> solverWriterFor(const std::string& path)
{
  return vtkSmartPointer<vtkSolverMeshWriter>::Take(vtkSolverMeshWriter::NewForFile(path.c_str()));
}

// OpenFOAM's mesh, a folder, which the writer makes.
bool endsInPolyMesh(const std::string& path)
{
  const fs::path given(path);
  return (given.has_filename() ? given : given.parent_path()).filename() == "polyMesh";
}

// The folders above it need not be there.
void checkFolderWritable(const std::string& path)
{
  fs::path folder = fs::absolute(path).parent_path();
  while (!fs::exists(folder) && folder.has_relative_path())
  {
    folder = folder.parent_path();
  }
  errno = fs::is_directory(folder) ? 0 : ENOTDIR;
  if (errno != 0 || access(folder.c_str(), W_OK) != 0)
  {
    throw std::runtime_error(path + ": cannot be written: " + std::strerror(errno));
  }
}
} // namespace

bool isSolverMesh(const std::string& path)
{
  return solverWriterFor(path) != nullptr;
}

bool canHoldSheets(const std::string& path)
{
  const auto writer = solverWriterFor(path);
  return !writer || writer->CanHoldSheets();
}

void checkWritable(const std::string& path)
{
  if (endsInPolyMesh(path))
  {
    checkFolderWritable(path);
    return;
  }
  if (fs::is_directory(path))
  {
    throw std::runtime_error(path + ": is a folder");
  }
  const std::string temporary = temporaryNameFor(path);
  const bool works = std::ofstream(temporary).good();
  const int reason = errno;
  std::error_code ignored;
  fs::remove(temporary, ignored);
  if (!works)
  {
    throw std::runtime_error(path + ": cannot be written: " + std::strerror(reason));
  }
}

void writeMesh(vtkUnstructuredGrid* mesh, const std::string& path, bool leaveOutSheets)
{
  if (const auto writer = solverWriterFor(path)) // which renames, too
  {
    vtkNew<Messages> messages;
    messages->watch(writer);
    writer->SetInputData(mesh);
    writer->SetLeaveOutSheets(leaveOutSheets);
    if (writer->Write() == 0)
    {
      throw std::runtime_error(
        messages->errors().empty() ? path + ": could not be written" : messages->errors().front());
    }
    return;
  }
  writeThenRename(path, [mesh](const std::string& name) { return writeXml<GridWriter>(mesh, name); });
}

void writeSurface(vtkPolyData* surface, const std::string& path)
{
  writeThenRename(
    path, [surface](const std::string& name) { return writeXml<SurfaceWriter>(surface, name); });
}

void writeText(const std::string& text, const std::string& path)
{
  writeThenRename(path,
    [&text](const std::string& name)
    {
      std::ofstream file(name);
      file << text;
      file.close();
      return file.good();
    });
}
} // namespace commandline

#include "MeshInput.h"

#include "Messages.h"

#include <vtkCGNSReader.h>
#include <vtkDataObject.h>
#include <vtkGmshMeshReader.h>
#include <vtkNew.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <stdexcept>

namespace commandline
{
namespace
{
std::string endingOf(const std::string& path)
{
  const std::size_t dot = path.rfind('.');
  std::string ending = dot == std::string::npos ? "" : path.substr(dot);
  std::transform(
    ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

vtkSmartPointer<vtkDataObject> read(vtkAlgorithm* reader, const std::string& path)
{
  vtkNew<Messages> messages;
  messages->watch(reader);
  reader->Update();
  vtkDataObject* data = reader->GetOutputDataObject(0);
  if (!messages->errors().empty() || !data || data->GetNumberOfElements(vtkDataObject::CELL) == 0)
  {
    throw std::runtime_error(
      messages->errors().empty() ? path + ": holds no mesh, or is damaged" : messages->errors().front());
  }
  return data;
}

template <class Reader>
vtkSmartPointer<vtkDataObject> readBy(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  return read(reader, path);
}

vtkSmartPointer<vtkDataObject> readCgns(const std::string& path)
{
  vtkNew<vtkCGNSReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetLoadBndPatch(true);
  reader->UpdateInformation();
  reader->EnableAllBases();
  reader->EnableAllFamilies();
  return read(reader, path);
}
} // namespace

bool isMeshFile(const std::string& path)
{
  constexpr std::array<const char*, 4> endings = { ".msh", ".vtu", ".vtk", ".cgns" };
  return std::find(endings.begin(), endings.end(), endingOf(path)) != endings.end();
}

vtkSmartPointer<vtkDataObject> readMesh(const std::string& path)
{
  if (!std::ifstream(path))
  {
    throw std::runtime_error(path + ": cannot be opened");
  }
  const std::string ending = endingOf(path);
  return ending == ".msh" ? readBy<vtkGmshMeshReader>(path)
    : ending == ".vtu"    ? readBy<vtkXMLUnstructuredGridReader>(path)
    : ending == ".vtk"    ? readBy<vtkUnstructuredGridReader>(path)
                          : readCgns(path);
}
} // namespace commandline

#include "vtkSolverMeshWriter.h"

#include "MeshView.h"
#include "vtkCGNSMeshWriter.h"
#include "vtkGmshMeshWriter.h"
#include "vtkOpenFOAMMeshWriter.h"
#include "vtkSU2MeshWriter.h"
#include "vtkUGRIDMeshWriter.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <new>
#include <string_view>

namespace
{
using ransmesh::MeshView;
using ransmesh::Outcome;

// Of those that a file cannot hold.
std::string namesOfSheets(const MeshView& mesh, vtkSolverMeshWriter* writer)
{
  std::string names;
  for (const auto& patch : mesh.patches())
  {
    if (patch.inside && !(patch.divides ? writer->CanHoldDividingSheets() : writer->CanHoldSheets()))
    {
      names += (names.empty() ? "" : ", ") + patch.name;
    }
  }
  return names;
}

template <class Writer>
vtkSolverMeshWriter* newWriter()
{
  return Writer::New();
}
} // namespace

vtkSolverMeshWriter::vtkSolverMeshWriter() = default;

vtkSolverMeshWriter::~vtkSolverMeshWriter()
{
  this->SetFileName(nullptr);
}

vtkUnstructuredGrid* vtkSolverMeshWriter::GetInput()
{
  return this->GetInput(0);
}

vtkUnstructuredGrid* vtkSolverMeshWriter::GetInput(int port)
{
  return vtkUnstructuredGrid::SafeDownCast(this->Superclass::GetInput(port));
}

vtkSolverMeshWriter* vtkSolverMeshWriter::NewForFile(const char* fileName)
{
  struct Format
  {
    std::string_view end;
    vtkSolverMeshWriter* (*make)();
  };
  static constexpr Format formats[] = {
    { ".su2", newWriter<vtkSU2MeshWriter> },
    { ".ugrid", newWriter<vtkUGRIDMeshWriter> },
    { ".cgns", newWriter<vtkCGNSMeshWriter> },
    { ".msh", newWriter<vtkGmshMeshWriter> },
    { "polyMesh", newWriter<vtkOpenFOAMMeshWriter> },
    { "polyMesh/", newWriter<vtkOpenFOAMMeshWriter> },
    { ".foam", newWriter<vtkOpenFOAMMeshWriter> },
  };
  const std::string_view name = fileName ? fileName : "";
  for (const Format& format : formats)
  {
    if (name.ends_with(format.end))
    {
      vtkSolverMeshWriter* writer = format.make();
      writer->SetFileName(fileName);
      return writer;
    }
  }
  return nullptr;
}

int vtkSolverMeshWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

void vtkSolverMeshWriter::WriteData()
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("There is no file name: call SetFileName.");
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    return;
  }
  Outcome outcome;
  try
  {
    MeshView mesh;
    outcome = MeshView::make(this->GetInput(), mesh);
    outcome = outcome.ok() ? this->WriteView(mesh) : outcome;
  }
  catch (const std::bad_alloc&)
  {
    outcome = Outcome::badInput("there is not enough memory");
  }
  if (!outcome.ok())
  {
    vtkErrorMacro("" << outcome.message);
    this->SetErrorCode(vtkErrorCode::UserError);
  }
}

Outcome vtkSolverMeshWriter::WriteView(MeshView& mesh)
{
  if (this->LeaveOutSheets)
  {
    mesh.leaveOutSheets(this->CanHoldSheets() || !this->CanHoldDividingSheets());
  }
  const std::string sheets = namesOfSheets(mesh, this);
  if (!sheets.empty())
  {
    return Outcome::badInput(std::string(this->FileName) +
      ": files of this kind cannot hold patches inside the mesh, and this mesh has: " + sheets +
      ". Leave out wakes with LeaveOutSheets, or write a polyMesh, .cgns or .msh");
  }
  return this->WriteMesh(mesh);
}

void vtkSolverMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n'
     << indent << "LeaveOutSheets: " << this->LeaveOutSheets << '\n';
}

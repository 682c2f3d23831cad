#include "vtkSurfaceCheck.h"

#include "PatchFieldData.h"
#include "ProblemOutput.h"
#include "StageContext.h"
#include "SurfaceFilterInput.h"
#include "SurfaceTables.h"

#include "Surface/Remedy.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkSurfaceCheck);

struct vtkSurfaceCheck::Internals
{
  std::string Text;
};

namespace
{
std::vector<ransmesh::SurfaceFinding> allFindings(const ransmesh::Diagnosis& diagnosis)
{
  std::vector<ransmesh::SurfaceFinding> findings;
  for (const ransmesh::Fault& fault : diagnosis.faults)
  {
    findings.insert(findings.end(), fault.findings.begin(), fault.findings.end());
  }
  return findings;
}

std::string reportOn(const ransmesh::Diagnosis& diagnosis, const ransmesh::SurfaceInput& input)
{
  const std::string size = std::to_string(diagnosis.triangles) + " triangles, " +
    std::to_string(diagnosis.points) + " points, " + std::to_string(diagnosis.pieces.size()) +
    (diagnosis.pieces.size() == 1 ? " piece" : " pieces");
  if (diagnosis.faults.empty())
  {
    return "nothing is wrong with the surface (" + size + ")";
  }
  const std::string text = ransmesh::describe(diagnosis, input.surface, input.patches) + " (" + size + ")";
  return diagnosis.isSound()
    ? text
    : text + ". Remedy: " + ransmesh::proposeRemedy(input.surface, input.patches, diagnosis);
}
} // namespace

//------------------------------------------------------------------------------
vtkSurfaceCheck::vtkSurfaceCheck()
  : Results(std::make_unique<Internals>())
{
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
vtkSurfaceCheck::~vtkSurfaceCheck() = default;

//------------------------------------------------------------------------------
void vtkSurfaceCheck::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NearTolerance: " << this->NearTolerance << "\n";
  os << indent << "Intersections: " << this->Intersections << "\n";
  os << indent << "Sound: " << this->Sound << "\n";
}

//------------------------------------------------------------------------------
const char* vtkSurfaceCheck::GetReportText() const
{
  return this->Results->Text.c_str();
}

//------------------------------------------------------------------------------
int vtkSurfaceCheck::FillInputPortInformation(int, vtkInformation* info)
{
  ransmesh::acceptSurfaces(info);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceCheck::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceCheck::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  *this->Results = {};
  this->Sound = false;
  ransmesh::SurfaceInput input;
  if (const auto outcome = ransmesh::readSurfaces(inputVector[0], input); !outcome.ok())
  {
    vtkErrorMacro(<< "Cannot check: " << outcome.message << ".");
    return 0;
  }
  ransmesh::DiagnosisOptions options;
  options.nearTolerance = this->NearTolerance;
  options.intersections = this->Intersections;
  const ransmesh::Context context = ransmesh::makeContext(this);
  const ransmesh::Diagnosis diagnosis = ransmesh::diagnose(input.surface, options, context);
  if (context.stopped())
  {
    return 1;
  }
  this->Sound = diagnosis.isSound();
  this->Results->Text = reportOn(diagnosis, input);
  vtkPolyData* problems = vtkPolyData::GetData(outputVector, 0);
  ransmesh::writeProblems(input.surface, allFindings(diagnosis), problems);
  ransmesh::writePatches(input.patches, problems->GetFieldData());
  ransmesh::writeFaults(
    ransmesh::faultRows(diagnosis, input.surface, input.patches), vtkTable::GetData(outputVector, 1));
  ransmesh::writePieces(diagnosis.pieces, input.patches, vtkTable::GetData(outputVector, 2));
  return 1;
}

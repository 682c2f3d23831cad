#include "vtkMeshQualityReport.h"

#include "MeshConversion.h"
#include "QualityInput.h"
#include "QualityOutput.h"
#include "StageContext.h"

#include "Quality/ReportJson.h"
#include "Quality/ReportText.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <fstream>

struct vtkMeshQualityReport::Internals
{
  std::string Text;
  std::string Json;
};

vtkStandardNewMacro(vtkMeshQualityReport);

vtkMeshQualityReport::vtkMeshQualityReport()
  : SpacingTolerance(ransmesh::ColumnRules{}.tolerance)
  , ColumnCone(ransmesh::ColumnRules{}.cone)
  , SmoothAngle(ransmesh::ReportOptions{}.smoothAngle)
  , Results(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

vtkMeshQualityReport::~vtkMeshQualityReport() = default;

const char* vtkMeshQualityReport::GetReportText() const
{
  return this->Results->Text.c_str();
}

const char* vtkMeshQualityReport::GetReportJson() const
{
  return this->Results->Json.c_str();
}

bool vtkMeshQualityReport::WriteJson(const char* fileName)
{
  if (this->Results->Json.empty())
  {
    vtkErrorMacro("There is no report to write yet: call Update first.");
    return false;
  }
  std::ofstream file(fileName ? fileName : "");
  file << this->Results->Json << std::flush;
  if (!file)
  {
    vtkErrorMacro("The report cannot be written to \""
      << (fileName ? fileName : "") << "\": check that its folder exists and may be written.");
    return false;
  }
  return true;
}

int vtkMeshQualityReport::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkMeshQualityReport::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkUnstructuredGrid" : "vtkTable");
  return 1;
}

int vtkMeshQualityReport::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  *this->Results = {};
  this->Valid = false;
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  ransmesh::QualityInput read;
  if (const auto outcome = ransmesh::readQualityInput(input, read); !outcome.ok())
  {
    vtkErrorMacro(<< outcome.message);
    return 0;
  }
  const ransmesh::LayerPlan plan = ransmesh::readPlan(input->GetFieldData());
  const ransmesh::ReportSubject subject{ read.mesh, read.patches, plan,
    read.layerIds.empty() ? nullptr : &read.layerIds, read.prisms ? &*read.prisms : nullptr,
    read.regions.empty() ? nullptr : &read.regions, read.regionNames };
  ransmesh::ReportOptions options;
  options.columns.tolerance = this->SpacingTolerance;
  options.columns.cone = this->ColumnCone;
  options.smoothAngle = this->SmoothAngle;
  const ransmesh::Context context = ransmesh::makeContext(this);
  ransmesh::CellMeasures cells;
  ransmesh::QualityReport report = ransmesh::reportQuality(subject, options, context, &cells);
  if (context.stopped())
  {
    return 1;
  }
  report.stops = ransmesh::countStops(vtkPolyData::GetData(inputVector[1]));
  this->Valid = report.isValid;
  this->Results->Text = ransmesh::reportText(report);
  this->Results->Json = ransmesh::reportJson(report);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector, 0);
  output->ShallowCopy(input);
  if (report.isMeasured)
  {
    ransmesh::addCellArrays(cells, read, output);
  }
  ransmesh::writeSummary(report, vtkTable::GetData(outputVector, 1));
  ransmesh::writeHistograms(report, vtkTable::GetData(outputVector, 2));
  return 1;
}

void vtkMeshQualityReport::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SpacingTolerance: " << this->SpacingTolerance << "\n";
  os << indent << "ColumnCone: " << this->ColumnCone << "\n";
  os << indent << "SmoothAngle: " << this->SmoothAngle << "\n";
  os << indent << "Valid: " << this->Valid << "\n";
}

#include "vtkDirectionalEnrichment.h"

#include "DebugCheck.h"
#include "EnrichmentOutput.h"
#include "MeshConversion.h"
#include "PatchFieldData.h"
#include "RegionArrays.h"
#include "StageContext.h"

#include "Insertion/EnrichedSheets.h"
#include "Layers/LayerPlanning.h"
#include "Mesh/RegionMemory.h"
#include "Mesh/Validation.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

namespace
{
// As "isotropic size reached 120, gap 2".
std::string reasonsOf(const ransmesh::EnrichmentReport& report)
{
  std::string text;
  for (std::size_t i = 0; i < report.columnsByReason.size(); ++i)
  {
    if (report.columnsByReason[i] > 0)
    {
      text += (text.empty() ? "" : ", ") + std::string(ransmesh::StopReasonTexts[i]) + " " +
        std::to_string(report.columnsByReason[i]);
    }
  }
  return text;
}

// The boundary shows both sides of sheets, which are one in the mesh.
ransmesh::Outcome makeLayers(ransmesh::MeshData& mesh, const ransmesh::PatchTable& patches,
  const ransmesh::LayerPlan& plan, const ransmesh::EnrichmentOptions& options,
  const ransmesh::Context& context, ransmesh::EnrichedMesh& enriched, vtkPolyData* boundary)
{
  ransmesh::OpenedSheets sheets;
  if (auto outcome = ransmesh::openSheets(mesh, sheets); !outcome.ok())
  {
    return outcome;
  }
  const ransmesh::PatchTable seen = ransmesh::patchesOfOpened(patches, sheets.patches, plan);
  if (auto outcome = ransmesh::enrichOpened(mesh, sheets, seen, plan, options, context, enriched);
      !outcome.ok())
  {
    return outcome;
  }
  ransmesh::writeEnrichedBoundary(enriched, patches, boundary);
  if (auto outcome = ransmesh::closeSheets(sheets, enriched); !outcome.ok())
  {
    return outcome;
  }
  return ransmesh::checkInDebugBuilds(enriched.mesh, "the enriched mesh");
}
} // namespace

vtkStandardNewMacro(vtkDirectionalEnrichment);

vtkDirectionalEnrichment::vtkDirectionalEnrichment()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkDirectionalEnrichment::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

int vtkDirectionalEnrichment::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector, 0);
  vtkPolyData* boundary = vtkPolyData::GetData(outputVector, 1);
  ransmesh::EnrichmentOptions options;
  options.gapFraction = this->GapFraction;
  options.maximumSurfaceAngle = this->MaximumSurfaceAngle;

  ransmesh::MeshData mesh;
  ransmesh::PatchTable patches;
  ransmesh::LayerPlan plan;
  ransmesh::EnrichedMesh enriched;
  ransmesh::Outcome outcome = ransmesh::readMesh(input, mesh, patches);
  const std::vector<int> regions = outcome.ok() ? ransmesh::readRegions(input) : std::vector<int>();
  const ransmesh::RegionMemory memory(mesh, regions);
  if (outcome.ok())
  {
    outcome = this->PlanLayers(mesh, patches, input->GetFieldData(), plan);
  }
  if (outcome.ok())
  {
    outcome = makeLayers(mesh, patches, plan, options, ransmesh::makeContext(this), enriched, boundary);
  }
  if (!outcome.ok())
  {
    boundary->Initialize();
    return this->Refuse(outcome);
  }

  ransmesh::writeEnrichedMesh(enriched, patches, input->GetPointData(), output);
  this->CarryRegions(regions, memory.recall(enriched.mesh, enriched.origin), output);
  output->GetFieldData()->PassData(input->GetFieldData());
  ransmesh::writePatches(patches, output->GetFieldData());
  ransmesh::writePlan(plan, output->GetFieldData());
  this->NumberOfRequestedPoints = static_cast<vtkIdType>(enriched.report.pointsRequested);
  this->NumberOfInsertedPoints = static_cast<vtkIdType>(enriched.report.pointsInserted);
  if (this->NumberOfInsertedPoints == 0)
  {
    vtkWarningMacro(<< "no layers were made; wall points by StopReason: " << reasonsOf(enriched.report));
  }
  return 1;
}

void vtkDirectionalEnrichment::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfRequestedPoints: " << this->NumberOfRequestedPoints << "\n";
  os << indent << "NumberOfInsertedPoints: " << this->NumberOfInsertedPoints << "\n";
}

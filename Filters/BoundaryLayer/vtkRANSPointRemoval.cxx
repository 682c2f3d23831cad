#include "vtkRANSPointRemoval.h"

#include "MeshConversion.h"
#include "PatchFieldData.h"
#include "StageContext.h"

#include "Mesh/Builder.h"
#include "Mesh/Validation.h"
#include "Removal/PointRemoval.h"
#include "Support/DataContract.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkRANSPointRemoval);

namespace
{
// The point data of the points that remain; newNumber gives each old point's new number, or None.
void keepPointData(vtkPointData* from, const std::vector<ransmesh::Index>& newNumber, vtkPointData* to)
{
  to->CopyFieldOff(ransmesh::contract::ColumnId); // columns of an earlier enrichment may be gone
  to->CopyAllocate(from);
  for (std::size_t i = 0; i < newNumber.size(); ++i)
  {
    if (newNumber[i] != ransmesh::None)
    {
      to->CopyData(from, static_cast<vtkIdType>(i), newNumber[i]);
    }
  }
}
} // namespace

int vtkRANSPointRemoval::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);

  ransmesh::MeshData data;
  ransmesh::PatchTable patches;
  ransmesh::LayerPlan plan;
  ransmesh::TetMesh mesh;
  ransmesh::RemovalResult result;
  ransmesh::RemovalOptions options;
  options.maximumSurfaceAngle = this->MaximumSurfaceAngle;
  const ransmesh::Context context = ransmesh::makeContext(this);

  ransmesh::Outcome outcome = ransmesh::readMesh(input, data, patches);
  if (outcome.ok())
  {
    outcome = this->PlanLayers(data, patches, input->GetFieldData(), plan);
  }
  if (outcome.ok())
  {
    outcome = ransmesh::buildTetMesh(data, mesh);
  }
  if (outcome.ok())
  {
    result = ransmesh::removePoints(mesh, patches, plan, options, context);
    outcome = result.outcome;
  }
#ifndef NDEBUG
  if (const auto faults = ransmesh::findFaults(mesh); outcome.ok() && !faults.none())
  {
    outcome = ransmesh::Outcome::internalFault("the mesh after point removal is not valid: " + faults.text());
  }
#endif
  if (!outcome.ok())
  {
    return this->Refuse(outcome);
  }
  std::vector<ransmesh::Index> newNumber;
  ransmesh::writeMesh(ransmesh::toMeshData(mesh, &newNumber), patches, output);
  keepPointData(input->GetPointData(), newNumber, output->GetPointData());
  output->GetFieldData()->PassData(input->GetFieldData());
  ransmesh::writePatches(patches, output->GetFieldData());
  ransmesh::writePlan(plan, output->GetFieldData());
  this->NumberOfMarkedPoints = static_cast<vtkIdType>(result.marked);
  this->NumberOfRemovedPoints = static_cast<vtkIdType>(result.removed);
  context.remark(result.text());
  return 1;
}

void vtkRANSPointRemoval::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfMarkedPoints: " << this->NumberOfMarkedPoints << "\n";
  os << indent << "NumberOfRemovedPoints: " << this->NumberOfRemovedPoints << "\n";
}

#include "vtkRANSPointRemoval.h"

#include "MeshConversion.h"
#include "PatchFieldData.h"
#include "RegionArrays.h"
#include "StageContext.h"

#include "Boundary/Sheets.h"
#include "Layers/LayerPlanning.h"
#include "Mesh/Builder.h"
#include "Mesh/RegionMemory.h"
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
// The mesh as it comes out, with its sheets closed. newNumber receives the number of each vertex in it, or
// None.
ransmesh::Outcome takeMesh(const ransmesh::TetMesh& mesh, const ransmesh::OpenedSheets& sheets,
  ransmesh::MeshData& data, std::vector<ransmesh::Index>& newNumber)
{
  data = ransmesh::toMeshData(mesh, &newNumber);
  std::vector<ransmesh::Index> closed;
  if (!sheets.any())
  {
    return ransmesh::Outcome::done();
  }
  ransmesh::Outcome outcome = ransmesh::closeSheets(data, sheets.patches, closed);
  for (ransmesh::Index& v : newNumber)
  {
    v = v == ransmesh::None ? ransmesh::None : closed[v];
  }
  return outcome;
}

// Of each point that remains, the input's.
std::vector<ransmesh::Index> originsOf(
  const std::vector<ransmesh::Index>& newNumber, const ransmesh::OpenedSheets& sheets, std::size_t points)
{
  std::vector<ransmesh::Index> origin(points, ransmesh::None);
  for (std::size_t i = 0; i < newNumber.size(); ++i)
  {
    if (newNumber[i] != ransmesh::None)
    {
      origin[newNumber[i]] = sheets.originOf(static_cast<ransmesh::Index>(i));
    }
  }
  return origin;
}

void keepPointData(vtkPointData* from, const std::vector<ransmesh::Index>& origin, vtkPointData* to)
{
  to->CopyFieldOff(ransmesh::contract::ColumnId); // columns of an earlier enrichment may be gone
  to->CopyAllocate(from);
  for (std::size_t i = 0; i < origin.size(); ++i)
  {
    to->CopyData(from, origin[i], static_cast<vtkIdType>(i));
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
  ransmesh::OpenedSheets sheets;
  ransmesh::TetMesh mesh;
  ransmesh::RemovalResult result;
  ransmesh::RemovalOptions options;
  options.maximumSurfaceAngle = this->MaximumSurfaceAngle;
  const ransmesh::Context context = ransmesh::makeContext(this);

  ransmesh::Outcome outcome = ransmesh::readMesh(input, data, patches);
  const std::vector<int> regions = outcome.ok() ? ransmesh::readRegions(input) : std::vector<int>();
  const ransmesh::RegionMemory memory(data, regions);
  if (outcome.ok())
  {
    outcome = this->PlanLayers(data, patches, input->GetFieldData(), plan);
  }
  if (outcome.ok())
  {
    outcome = ransmesh::openSheets(data, sheets);
  }
  if (outcome.ok())
  {
    outcome = ransmesh::buildTetMesh(data, mesh);
  }
  if (outcome.ok())
  {
    result = ransmesh::removePoints(
      mesh, ransmesh::withFrozenSheets(patches, sheets.patches), plan, options, context);
    outcome = result.outcome;
  }
  std::vector<ransmesh::Index> newNumber;
  if (outcome.ok())
  {
    outcome = takeMesh(mesh, sheets, data, newNumber);
  }
#ifndef NDEBUG
  if (const auto faults = ransmesh::findFaults(data); outcome.ok() && !faults.none())
  {
    outcome = ransmesh::Outcome::internalFault("the mesh after point removal is not valid: " + faults.text());
  }
#endif
  if (!outcome.ok())
  {
    return this->Refuse(outcome);
  }
  ransmesh::writeMesh(data, patches, output);
  const std::vector<ransmesh::Index> origin = originsOf(newNumber, sheets, data.points.size());
  keepPointData(input->GetPointData(), origin, output->GetPointData());
  this->CarryRegions(regions, memory.recall(data, origin), output);
  output->GetFieldData()->PassData(input->GetFieldData());
  ransmesh::writePatches(patches, output->GetFieldData());
  ransmesh::writePlan(plan, output->GetFieldData());
  this->NumberOfMarkedPoints = static_cast<vtkIdType>(result.marked);
  this->NumberOfRemovedPoints = static_cast<vtkIdType>(result.removed);
  this->NumberOfShapePoints = static_cast<vtkIdType>(result.neededByShape);
  context.remark(result.text());
  return 1;
}

void vtkRANSPointRemoval::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfMarkedPoints: " << this->NumberOfMarkedPoints << "\n";
  os << indent << "NumberOfRemovedPoints: " << this->NumberOfRemovedPoints << "\n";
  os << indent << "NumberOfShapePoints: " << this->NumberOfShapePoints << "\n";
}

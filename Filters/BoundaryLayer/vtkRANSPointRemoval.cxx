#include "vtkRANSPointRemoval.h"

#include "DebugCheck.h"
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

struct Room
{
  ransmesh::RemovalResult result;
  std::vector<ransmesh::Index> origin; // of each point that remains, the input's
};

ransmesh::Outcome makeRoom(ransmesh::MeshData& mesh, const ransmesh::PatchTable& patches,
  const ransmesh::LayerPlan& plan, const ransmesh::RemovalOptions& options, const ransmesh::Context& context,
  Room& room)
{
  ransmesh::OpenedSheets sheets;
  if (auto outcome = ransmesh::openSheets(mesh, sheets); !outcome.ok())
  {
    return outcome;
  }
  ransmesh::TetMesh opened;
  if (auto outcome = ransmesh::buildTetMesh(mesh, opened); !outcome.ok())
  {
    return outcome;
  }
  room.result = ransmesh::removePoints(
    opened, ransmesh::withFrozenSheets(patches, sheets.patches), plan, options, context);
  if (!room.result.outcome.ok())
  {
    return room.result.outcome;
  }
  std::vector<ransmesh::Index> newNumber;
  if (auto outcome = takeMesh(opened, sheets, mesh, newNumber); !outcome.ok())
  {
    return outcome;
  }
  room.origin = originsOf(newNumber, sheets, mesh.points.size());
  return ransmesh::checkInDebugBuilds(mesh, "the mesh after point removal");
}
} // namespace

int vtkRANSPointRemoval::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  const ransmesh::Context context = ransmesh::makeContext(this);
  ransmesh::RemovalOptions options;
  options.maximumSurfaceAngle = this->MaximumSurfaceAngle;

  ransmesh::MeshData mesh;
  ransmesh::PatchTable patches;
  ransmesh::LayerPlan plan;
  Room room;
  ransmesh::Outcome outcome = ransmesh::readMesh(input, mesh, patches);
  const std::vector<int> regions = outcome.ok() ? ransmesh::readRegions(input) : std::vector<int>();
  const ransmesh::RegionMemory memory(mesh, regions);
  if (outcome.ok())
  {
    outcome = this->PlanLayers(mesh, patches, input->GetFieldData(), plan);
  }
  if (outcome.ok())
  {
    outcome = makeRoom(mesh, patches, plan, options, context, room);
  }
  if (!outcome.ok())
  {
    return this->Refuse(outcome);
  }

  ransmesh::writeMesh(mesh, patches, output);
  keepPointData(input->GetPointData(), room.origin, output->GetPointData());
  this->CarryRegions(regions, memory.recall(mesh, room.origin), output);
  output->GetFieldData()->PassData(input->GetFieldData());
  ransmesh::writePatches(patches, output->GetFieldData());
  ransmesh::writePlan(plan, output->GetFieldData());
  this->NumberOfMarkedPoints = static_cast<vtkIdType>(room.result.marked);
  this->NumberOfRemovedPoints = static_cast<vtkIdType>(room.result.removed);
  this->NumberOfShapePoints = static_cast<vtkIdType>(room.result.neededByShape);
  context.remark(room.result.text());
  return 1;
}

void vtkRANSPointRemoval::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfMarkedPoints: " << this->NumberOfMarkedPoints << "\n";
  os << indent << "NumberOfRemovedPoints: " << this->NumberOfRemovedPoints << "\n";
  os << indent << "NumberOfShapePoints: " << this->NumberOfShapePoints << "\n";
}

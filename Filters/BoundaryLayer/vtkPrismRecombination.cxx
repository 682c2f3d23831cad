#include "vtkPrismRecombination.h"

#include "DebugCheck.h"
#include "MeshConversion.h"
#include "MixedConversion.h"
#include "StageContext.h"

#include "Mesh/MixedValidation.h"
#include "Prisms/Recombination.h"
#include "Support/DataContract.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

namespace
{
using ransmesh::Index;
namespace contract = ransmesh::contract;

// The grid's numbers of its cells of one type.
std::vector<vtkIdType> CellsOfType(vtkUnstructuredGrid* grid, int type)
{
  std::vector<vtkIdType> ids;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    if (grid->GetCellType(c) == type)
    {
      ids.push_back(c);
    }
  }
  return ids;
}

ransmesh::Outcome ReadPrisms(
  vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& tets, std::vector<Index>& prism)
{
  vtkDataArray* array = grid->GetCellData()->GetArray(contract::PrismId);
  if (!array || array->GetNumberOfComponents() != 1)
  {
    return ransmesh::Outcome::badInput(
      "the mesh has no cell array PrismId, which tells the tetrahedra of each "
      "prism: make its layers with vtkDirectionalEnrichment");
  }
  for (const vtkIdType t : tets)
  {
    prism.push_back(static_cast<Index>(array->GetTuple1(t)));
  }
  return ransmesh::Outcome::done();
}

// Cells take the data of one of the tetrahedra, or triangles, that they are made of; PatchId is there already.
void CarryCellData(const ransmesh::RecombinedMesh& result, vtkUnstructuredGrid* input,
  const std::vector<vtkIdType>& tets, vtkUnstructuredGrid* output)
{
  const std::vector<vtkIdType> triangles = CellsOfType(input, VTK_TRIANGLE);
  vtkCellData* to = output->GetCellData();
  vtkSmartPointer<vtkDataArray> patchIds = to->GetArray(contract::PatchId);
  to->CopyAllocate(input->GetCellData(), output->GetNumberOfCells());
  vtkIdType cell = 0;
  for (const Index origin : result.cellOrigin)
  {
    to->CopyData(input->GetCellData(), tets[origin], cell++);
  }
  for (const Index origin : result.boundaryOrigin)
  {
    to->CopyData(input->GetCellData(), triangles[origin], cell++);
  }
  to->AddArray(patchIds);
}

void CarryPointData(
  const ransmesh::RecombinedMesh& result, vtkUnstructuredGrid* input, vtkUnstructuredGrid* output)
{
  vtkPointData* to = output->GetPointData();
  to->CopyAllocate(input->GetPointData(), output->GetNumberOfPoints());
  to->CopyData(input->GetPointData(), 0, input->GetNumberOfPoints(), 0);
  vtkDataArray* columns = to->GetArray(contract::ColumnId);
  vtkIdType point = input->GetNumberOfPoints();
  for (const Index origin : result.newPointOrigin)
  {
    to->CopyData(input->GetPointData(), origin, point);
    if (columns)
    {
      columns->SetTuple1(point, ransmesh::None);
    }
    ++point;
  }
}
} // namespace

vtkStandardNewMacro(vtkPrismRecombination);

int vtkPrismRecombination::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  const std::vector<vtkIdType> tets = CellsOfType(input, VTK_TETRA);
  const ransmesh::Context context = ransmesh::makeContext(this);

  ransmesh::MeshData mesh;
  ransmesh::PatchTable patches;
  std::vector<Index> prism;
  ransmesh::RecombinedMesh result;
  ransmesh::Outcome outcome = ransmesh::readMesh(input, mesh, patches);
  if (outcome.ok())
  {
    outcome = ReadPrisms(input, tets, prism);
  }
  if (outcome.ok())
  {
    outcome = ransmesh::recombinePrisms(mesh, prism, this->MaximumNonOrthogonality, context, result);
  }
  if (outcome.ok())
  {
    outcome = ransmesh::checkInDebugBuilds(result.mesh, "the mesh with prisms");
  }
  if (outcome.kind == ransmesh::Outcome::Kind::Cancelled)
  {
    return 1;
  }
  if (!outcome.ok())
  {
    vtkErrorMacro(<< outcome.message);
    return 0;
  }
  ransmesh::writeMixedMesh(result.mesh, patches, output);
  CarryCellData(result, input, tets, output);
  CarryPointData(result, input, output);
  output->GetFieldData()->PassData(input->GetFieldData());
  this->ShareOfLayers = result.report.shareInWedges();
  this->NumberOfWedges = static_cast<vtkIdType>(result.mesh.wedges.size());
  this->NumberOfHexahedra = static_cast<vtkIdType>(result.mesh.hexahedra.size());
  this->NumberOfPyramids = static_cast<vtkIdType>(result.mesh.pyramids.size());
  this->NumberOfAddedPoints = static_cast<vtkIdType>(result.report.newPoints);
  this->NumberOfMovedPoints = static_cast<vtkIdType>(result.report.orthogonality.movedPoints);
  return 1;
}

void vtkPrismRecombination::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumNonOrthogonality: " << this->MaximumNonOrthogonality << "\n";
  os << indent << "ShareOfLayers: " << this->ShareOfLayers << "\n";
  os << indent << "NumberOfWedges: " << this->NumberOfWedges << "\n";
  os << indent << "NumberOfHexahedra: " << this->NumberOfHexahedra << "\n";
  os << indent << "NumberOfPyramids: " << this->NumberOfPyramids << "\n";
  os << indent << "NumberOfAddedPoints: " << this->NumberOfAddedPoints << "\n";
  os << indent << "NumberOfMovedPoints: " << this->NumberOfMovedPoints << "\n";
}

#include "vtkSurfaceRepair.h"

#include "SurfaceFilterInput.h"
#include "SurfaceOutput.h"
#include "SurfaceTables.h"

#include "Triangles/SurfaceCheck.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkSurfaceRepair);

//------------------------------------------------------------------------------
vtkSurfaceRepair::vtkSurfaceRepair()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkSurfaceRepair::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "WeldTolerance: " << this->WeldTolerance << "\n";
  os << indent << "ShortestEdge: " << this->ShortestEdge << "\n";
  os << indent << "LargestHole: " << this->LargestHole << "\n";
}

//------------------------------------------------------------------------------
int vtkSurfaceRepair::FillInputPortInformation(int, vtkInformation* info)
{
  ransmesh::acceptSurfaces(info);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceRepair::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceRepair::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  ransmesh::SurfaceInput input;
  ransmesh::Outcome outcome = ransmesh::readSurfaces(inputVector[0], input);
  if (outcome.ok())
  {
    outcome = ransmesh::checkCoordinates(input.surface, "surface");
  }
  if (!outcome.ok())
  {
    vtkErrorMacro(<< "Cannot repair: " << outcome.message << ".");
    return 0;
  }
  ransmesh::RepairOptions options;
  options.weldTolerance = this->WeldTolerance;
  options.shortestEdge = this->ShortestEdge;
  options.largestHole = this->LargestHole;
  const auto repairs = ransmesh::repairSurface(input.surface, input.patches, options);
  for (const ransmesh::Repair& repair : repairs)
  {
    vtkWarningMacro("Mended: " << repair.text << ".");
  }
  ransmesh::writeSurface(input.surface, input.patches, vtkPolyData::GetData(outputVector, 0));
  ransmesh::writeRepairs(repairs, vtkTable::GetData(outputVector, 1));
  return 1;
}

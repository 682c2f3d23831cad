#include "vtkSurfaceWrap.h"

#include "StageContext.h"
#include "SurfaceFilterInput.h"
#include "SurfaceOutput.h"

#include "Support/DataContract.h"
#include "Surface/Wrapping.h"
#include "Triangles/SurfaceCheck.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkSurfaceWrap);

namespace
{
void writeNumber(const char* name, double value, vtkPolyData* output)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  output->GetFieldData()->AddArray(array);
}
} // namespace

//------------------------------------------------------------------------------
void vtkSurfaceWrap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Alpha: " << this->Alpha << "\n";
  os << indent << "Offset: " << this->Offset << "\n";
  os << indent << "AlphaUsed: " << this->AlphaUsed << "\n";
  os << indent << "OffsetUsed: " << this->OffsetUsed << "\n";
}

//------------------------------------------------------------------------------
int vtkSurfaceWrap::FillInputPortInformation(int, vtkInformation* info)
{
  ransmesh::acceptSurfaces(info);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceWrap::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->AlphaUsed = this->OffsetUsed = 0;
  ransmesh::SurfaceInput input;
  ransmesh::Outcome outcome = ransmesh::readSurfaces(inputVector[0], input);
  if (outcome.ok())
  {
    outcome = ransmesh::checkExtent(input.surface);
  }
  ransmesh::WrapReport report;
  if (outcome.ok())
  {
    const double alpha = this->Alpha == 0 ? ransmesh::proposedAlpha(input.surface) : this->Alpha;
    outcome =
      ransmesh::wrapSurface(input.surface, { alpha, this->Offset }, ransmesh::makeContext(this), report);
  }
  if (!outcome.ok())
  {
    vtkErrorMacro(<< "Cannot wrap: " << outcome.message << ".");
    return 0;
  }
  this->AlphaUsed = report.alpha;
  this->OffsetUsed = report.offset;
  vtkWarningMacro("Wrapped: what is narrower than " << report.alpha << " is bridged, the new surface of "
                                                    << report.triangles << " triangles lies " << report.offset
                                                    << " outside the given one.");
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  ransmesh::writeSurface(input.surface, input.patches, output);
  writeNumber(ransmesh::contract::WrapAlpha, report.alpha, output);
  writeNumber(ransmesh::contract::WrapOffset, report.offset, output);
  return 1;
}

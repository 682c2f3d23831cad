#include "vtkSurfaceCheck.h"

#include "ProblemOutput.h"
#include "SurfaceInput.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkSurfaceCheck);

//------------------------------------------------------------------------------
vtkSurfaceCheck::vtkSurfaceCheck()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkSurfaceCheck::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
int vtkSurfaceCheck::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
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
  std::vector<vtkDataObject*> inputs;
  for (int i = 0; i < inputVector[0]->GetNumberOfInformationObjects(); ++i)
  {
    inputs.push_back(vtkDataObject::GetData(inputVector[0], i));
  }
  ransmesh::SurfaceInput input;
  if (const auto outcome = ransmesh::readSurface(inputs, {}, input); !outcome.ok())
  {
    vtkErrorMacro(<< "Cannot check: " << outcome.message << ".");
    return 0;
  }
  const auto verdict = ransmesh::mendAndCheck(input.surface, input.patches);
  ransmesh::writeProblems(input.surface, verdict.findings, vtkPolyData::GetData(outputVector, 0));
  return 1;
}

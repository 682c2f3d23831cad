#include "SurfaceFilterInput.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

namespace ransmesh
{
void acceptSurfaces(vtkInformation* port)
{
  port->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  port->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
}

std::vector<vtkDataObject*> dataOf(vtkInformationVector* port)
{
  std::vector<vtkDataObject*> data;
  for (int i = 0; i < port->GetNumberOfInformationObjects(); ++i)
  {
    data.push_back(vtkDataObject::GetData(port, i));
  }
  return data;
}

Outcome readSurfaces(vtkInformationVector* port, SurfaceInput& input)
{
  Outcome outcome = readSurface(dataOf(port), {}, input);
  if (outcome.ok() && input.surface.triangles.empty())
  {
    return Outcome::badInput("the input is empty: connect a surface of triangles or polygons");
  }
  return outcome;
}
} // namespace ransmesh

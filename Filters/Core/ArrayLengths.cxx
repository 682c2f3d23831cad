#include "ArrayLengths.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

#include <string>

namespace ransmesh
{
namespace
{
Outcome check(vtkFieldData* arrays, vtkIdType count, const std::string& of)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(i);
    if (array->GetNumberOfTuples() < count)
    {
      return Outcome::badInput("the " + of + " array " +
        (array->GetName() ? array->GetName() : "without a name") + " has " +
        std::to_string(array->GetNumberOfTuples()) + " values for " + std::to_string(count) + " " + of +
        "s: give it one for each, or remove it");
    }
  }
  return Outcome::done();
}
} // namespace

Outcome checkArrayLengths(vtkDataSet* data)
{
  if (Outcome outcome = check(data->GetPointData(), data->GetNumberOfPoints(), "point"); !outcome.ok())
  {
    return outcome;
  }
  return check(data->GetCellData(), data->GetNumberOfCells(), "cell");
}
} // namespace ransmesh

// Large VTK arrays, filled once from end to end.
#pragma once

#include "Support/LargeMemory.h"

#include "vtkType.h"

#include <cstddef>

namespace ransmesh
{
// Gives the array that many values, not set yet, by large pages where that is worthwhile.
template <class Array>
typename Array::ValueType* resizeLarge(Array* array, vtkIdType values)
{
  array->SetNumberOfValues(values);
  auto* const first = array->GetPointer(0);
  preferLargePages(first, static_cast<std::size_t>(values) * sizeof(*first));
  return first;
}
} // namespace ransmesh

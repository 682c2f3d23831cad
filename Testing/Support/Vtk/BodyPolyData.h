// A body as the mesher's input.
#pragma once

#include "Bodies/Body.h"

#include <vtkSmartPointer.h>

class vtkPolyData;

namespace bodies
{
// With PatchId, PatchNames and PatchTypes.
vtkSmartPointer<vtkPolyData> toPolyData(const Body& body);
} // namespace bodies

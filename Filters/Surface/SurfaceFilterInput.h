// What the filters of this module have in common: surfaces in, with patches.
#pragma once

#include "SurfaceInput.h"

class vtkDataObject;
class vtkInformation;
class vtkInformationVector;

namespace ransmesh
{
// Poly data, or composite data of them, from any number of connections.
void acceptSurfaces(vtkInformation* port);

// What is connected to a port.
std::vector<vtkDataObject*> dataOf(vtkInformationVector* port);

// What all connections of a port hold, as one surface. BadInput where there are no triangles, too.
Outcome readSurfaces(vtkInformationVector* port, SurfaceInput& input);
} // namespace ransmesh

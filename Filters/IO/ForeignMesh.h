// Meshes that other programs made, in the kernel's terms.
#pragma once

#include "Boundary/MeshAdoption.h"
#include "Mesh/MeshData.h"
#include "Support/Outcome.h"
#include "Support/Patch.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace ransmesh
{
// Takes tetrahedra and triangles together from data sets and composite data of them; lines and points are left out,
// cells of second order keep their corners. The patch of a triangle: the array PatchId; an array that another tool
// has left; the name of its block, if that holds triangles only; else 0, which is unknown. Regions: the array
// RegionId and RegionNames, if all tetrahedra have one. BadInput for other cells of the volume.
Outcome readForeignMesh(const std::vector<vtkDataObject*>& inputs, MeshData& mesh, NamedRegions& regions,
  PatchTable& patches, std::vector<std::string>& remarks);
} // namespace ransmesh

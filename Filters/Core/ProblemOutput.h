// The triangles that are wrong with a surface, as poly data.
#pragma once

#include "Triangles/SurfaceCheck.h"

#include "RANSMeshingCoreModule.h"

class vtkPolyData;

namespace ransmesh
{
// One triangle a finding, with the cell arrays Reason, PartnerId (the cell number of the partner here, or
// -1) and PatchId, and the field data ReasonNames. Points that are not finite are shown near their triangles.
// No findings: an empty output with these arrays.
RANSMESHINGCORE_EXPORT void writeProblems(
  const SurfaceMesh& surface, const std::vector<SurfaceFinding>& findings, vtkPolyData* output);
} // namespace ransmesh

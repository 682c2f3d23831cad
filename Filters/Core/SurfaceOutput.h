// A triangulated surface with patches, as poly data.
#ifndef SurfaceOutput_h
#define SurfaceOutput_h

#include "Support/Patch.h"
#include "Triangles/SurfaceMesh.h"

#include "RANSMeshingCoreModule.h"

class vtkPolyData;

namespace ransmesh
{
// Writes points, triangles, the cell array PatchId and the field data PatchNames and PatchTypes, so that
// readSurface (SurfaceInput.h) reads the same back; output is emptied first.
RANSMESHINGCORE_EXPORT void writeSurface(
  const SurfaceMesh& surface, const PatchTable& patches, vtkPolyData* output);
} // namespace ransmesh

#endif

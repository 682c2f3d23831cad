// The patch table in a data set's field data.
#ifndef PatchFieldData_h
#define PatchFieldData_h

#include "Support/Patch.h"

#include "RANSMeshingCoreModule.h"

class vtkFieldData;

namespace ransmesh
{
// The patches that the field data name (PatchNames, PatchTypes); empty if there are none. Unknown types
// become `patch`.
RANSMESHINGCORE_EXPORT PatchTable readPatches(vtkFieldData* fieldData);

// Writes PatchNames and PatchTypes, replacing what was there.
RANSMESHINGCORE_EXPORT void writePatches(const PatchTable& patches, vtkFieldData* fieldData);
} // namespace ransmesh

#endif

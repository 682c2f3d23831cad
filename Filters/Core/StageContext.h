// What a stage of the kernel is given when a VTK filter runs it.
#ifndef StageContext_h
#define StageContext_h

#include "Support/Context.h"

#include "RANSMeshingCoreModule.h"

class vtkAlgorithm;

namespace ransmesh
{
// Progress goes to the algorithm's progress events, its abort flag stops the stage, remarks go to
// VTK's log at verbosity 1, which is silent by default. The algorithm must outlive the context.
RANSMESHINGCORE_EXPORT Context makeContext(vtkAlgorithm* algorithm);
} // namespace ransmesh

#endif

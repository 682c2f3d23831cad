#include "StageContext.h"

#include "vtkAlgorithm.h"
#include "vtkLogger.h"
#include "vtkVersionMacros.h"

namespace ransmesh
{
Context makeContext(vtkAlgorithm* algorithm)
{
  Context context;
  context.progress = [algorithm](double fraction, const char* phase)
  {
    algorithm->SetProgressText(phase);
    algorithm->UpdateProgress(fraction);
  };
  context.cancelled = [algorithm]()
  {
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
    return algorithm->CheckAbort();
#else
    return algorithm->GetAbortExecute() != 0;
#endif
  };
  context.log = [algorithm](const std::string& text)
  { vtkVLogF(vtkLogger::VERBOSITY_1, "%s: %s", algorithm->GetClassName(), text.c_str()); };
  return context;
}
} // namespace ransmesh

// A surface as it was given, made ready to be meshed, or refused with reasons.
#pragma once

#include "Surface/Diagnosis.h"
#include "Surface/Repair.h"

namespace ransmesh
{
struct PreparationOptions
{
  bool repair = true;
  RepairOptions repairs;
  DiagnosisOptions diagnosis;
  // For both of them. In these planes edges may be open, and stay so.
  std::vector<AxisPlane> closedBy;
};

// Mends what is harmless, if that is wanted, and says whether the surface can bound a mesh then. Where it
// cannot, the verdict tells what is wrong with the surface as it was given, and proposes a remedy that was tried
// out, or wrapping; the surface is left as it was given then, with points of equal coordinates merged.
SurfaceVerdict prepareSurface(
  SurfaceMesh& surface, PatchTable& patches, const PreparationOptions& options, const Context& context);
} // namespace ransmesh

// From the surfaces as they come to the domain that is to be meshed.
#pragma once

#include "MesherReport.h"
#include "MesherSettings.h"
#include "SurfaceInput.h"

namespace ransmesh
{
// Mends and checks the surface, gives it the patches and triangles that the settings want, puts a box around
// it and sheets into it. BadInput with the triangles that are wrong in the report, where they are known.
Outcome prepareDomain(
  const MesherSettings& settings, SurfaceInput input, Domain& domain, MesherReport& report);
} // namespace ransmesh

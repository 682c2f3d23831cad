// The layers on the walls, with both sides of the sheets among them.
#pragma once

#include "Mesh/FaceMatching.h"
#include "Quality/WallAssessment.h"

namespace ransmesh
{
// As assessWalls, on a copy of the mesh that is cut open along its sheets, if it has any with layers. Where the
// mesh is too poor to be cut open, one side of them is assessed.
WallAssessment assessBothSides(const ReportSubject& subject, const FaceMatching& matching,
  const std::vector<HalfFace>& innerFaces, const ReportOptions& options, const Context& context);
} // namespace ransmesh

// The layers on the walls, measured.
#pragma once

#include "Quality/QualityReport.h"

#include <vector>

namespace ransmesh
{
struct WallAssessment
{
  std::vector<WallSummary> walls;    // all walls together first, then each; empty without layers
  std::vector<Histogram> histograms; // of all walls together, and layers by column of each
  std::vector<char> onColumn;        // of each point: is it on a column, smooth foot or not
};

WallAssessment assessWalls(const ReportSubject& subject, const std::vector<HalfFace>& innerFaces,
  const ReportOptions& options, const Context& context);
} // namespace ransmesh

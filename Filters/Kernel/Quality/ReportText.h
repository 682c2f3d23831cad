// A quality report for reading in a terminal: one screen, aligned, 100 columns.
#pragma once

#include "Quality/QualityReport.h"

#include <string>

namespace ransmesh
{
std::string reportText(const QualityReport& report);
} // namespace ransmesh

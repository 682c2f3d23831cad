// A quality report as JSON, for scripts: everything that the report holds, quantities named as in ReportRows.
#pragma once

#include "Quality/QualityReport.h"

#include <string>

namespace ransmesh
{
std::string reportJson(const QualityReport& report);
} // namespace ransmesh

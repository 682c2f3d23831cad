// A quality report as rows of a table: one figure each.
#pragma once

#include "Quality/QualityReport.h"

#include <string>
#include <vector>

namespace ransmesh
{
struct ReportRow
{
  std::string quantity; // for example "LargestDihedral p99" or "ShareOfColumnsFull"
  double value = 0;
  std::string unit;  // "1", "degrees", "length", "length^2", "length^3", "points", ...
  std::string scope; // "whole", "layers" or a patch's name
};

std::vector<ReportRow> reportRows(const QualityReport& report);

// "p0" to "p100".
std::string percentName(double percent);

// Each fault's name, as the rows and the JSON give it, and its count.
struct NamedFault
{
  const char* name;
  std::size_t count;
};
std::vector<NamedFault> namedFaults(const MeshFaults& faults);
} // namespace ransmesh

// The ranges of filters' options, checked and told in one way.
#ifndef OptionRange_h
#define OptionRange_h

#include "Support/Outcome.h"

#include "RANSMeshingCoreModule.h"

#include <vector>

namespace ransmesh
{
struct OptionRange
{
  const char* name;
  double value;
  double low;
  double high;
};

// Lengths and places may have any size that is sure not to overflow when it is squared.
inline constexpr double LargestLength = 1e50;

// BadInput names the first option whose value is not between its bounds, or not a number.
RANSMESHINGCORE_EXPORT Outcome checkRanges(const std::vector<OptionRange>& options);
} // namespace ransmesh

#endif

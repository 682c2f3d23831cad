#include "OptionRange.h"

#include <sstream>

namespace ransmesh
{
Outcome checkRanges(const std::vector<OptionRange>& options)
{
  for (const OptionRange& option : options)
  {
    if (!(option.value >= option.low && option.value <= option.high))
    {
      std::ostringstream text;
      text << option.name << " is " << option.value << "; it must lie between " << option.low << " and "
           << option.high;
      return Outcome::badInput(text.str());
    }
  }
  return Outcome::done();
}
} // namespace ransmesh

#include "Arguments.h"

namespace commandline
{
namespace
{
double lengthOf(Arguments& arguments, const std::string& option)
{
  const std::string& word = arguments.valueOf(option);
  const double value = finiteNumber(word, option);
  if (value < 0)
  {
    throw UsageError(option + " must not be negative: " + word);
  }
  return value;
}

// ALPHA or ALPHA:OFFSET
void readWrap(RepairOptions& repair, Arguments& arguments, const std::string& option)
{
  const std::string word = arguments.valueOf(option);
  const std::size_t colon = word.find(':');
  repair.wrapAlpha = finiteNumber(word.substr(0, colon), option);
  repair.wrapOffset = colon == std::string::npos ? 0 : finiteNumber(word.substr(colon + 1), option);
  if (repair.wrapAlpha <= 0 || repair.wrapOffset < 0 ||
    (colon != std::string::npos && repair.wrapOffset == 0))
  {
    throw UsageError(option + " needs lengths above 0, ALPHA or ALPHA:OFFSET, not \"" + word + "\"");
  }
}

void check(const Options& options)
{
  const RepairOptions& repair = options.repair;
  if (!repair.repair && (repair.weld >= 0 || repair.shortestEdge >= 0 || repair.largestHole > 0))
  {
    throw UsageError("--no-repair with --weld, --shortest-edge or --fill-holes: leave out one of them");
  }
}
} // namespace

const OptionGroup& repairOptions()
{
  using O = Options;
  using A = Arguments;
  using S = const std::string;
  static const OptionGroup group = {
    {
      { "--no-repair", [](O& o, A&, S&) { o.repair.repair = false; } },
      { "--weld", [](O& o, A& a, S& name) { o.repair.weld = lengthOf(a, name); } },
      { "--shortest-edge", [](O& o, A& a, S& name) { o.repair.shortestEdge = lengthOf(a, name); } },
      { "--fill-holes", [](O& o, A& a, S& name) { o.repair.largestHole = positiveOf(a, name); } },
      { "--wrap", [](O& o, A& a, S& name) { readWrap(o.repair, a, name); } },
      { "--time-limit", [](O& o, A& a, S& name) { o.timeLimit = positiveOf(a, name); } },
      { "--memory-limit", [](O& o, A& a, S& name) { o.memoryLimit = positiveOf(a, name); } },
    },
    check, R"(
Faulty surfaces (repairs are reported as warnings)
  --weld L              points of open edges within L of each other become one (1e-6 of the extent)
  --shortest-edge L     shorter surface edges are collapsed (1e-9 of the extent)
  --fill-holes L        holes of at most this extent are filled (none)
  --no-repair           nothing is mended
  --wrap A[:D]          a closed surface is wrapped around the given one: what is narrower than A is
                        bridged; it lies D outside (A / 30)
  --time-limit S        seconds for each run of TetGen (no limit)
  --memory-limit M      megabytes for each run of TetGen (no limit)
)"
  };
  return group;
}
} // namespace commandline

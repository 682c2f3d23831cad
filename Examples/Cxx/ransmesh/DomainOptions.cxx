#include "Arguments.h"

namespace commandline
{
namespace
{
void check(const Options&) {}
} // namespace

const OptionGroup& domainOptions()
{
  using O = Options;
  using A = Arguments;
  using S = const std::string;
  static const OptionGroup group = {
    {
      { "--far-field", [](O& o, A& a, S& name) { o.farField = positiveOf(a, name); } },
      { "--size", [](O& o, A& a, S& name) { o.size = positiveOf(a, name); } },
    },
    check, R"(
Domain
  --far-field M         a box around the bodies, M body lengths on each side;
                        without it the surfaces themselves bound the domain
  --size L              largest edge in the field
)"
  };
  return group;
}
} // namespace commandline

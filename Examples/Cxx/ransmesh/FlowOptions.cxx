#include "Arguments.h"

#include <algorithm>
#include <array>

namespace commandline
{
namespace
{
constexpr std::array Fluids = { "air", "water", "custom" };

void checkName(const char* option, const std::string& name, const std::vector<std::string>& known)
{
  if (name.empty() || std::find(known.begin(), known.end(), name) != known.end())
  {
    return;
  }
  std::string list;
  for (const std::string& each : known)
  {
    list += (list.empty() ? "" : ", ") + each;
  }
  throw UsageError(std::string(option) + " is one of " + list + ", not \"" + name + "\"");
}

void checkFluid(const FlowOptions& flow)
{
  checkName("--fluid", flow.fluid, { Fluids.begin(), Fluids.end() });
  const bool isCustom = flow.density > 0 || flow.viscosity > 0;
  if ((isCustom || flow.fluid == "custom") && (flow.density == 0 || flow.viscosity == 0))
  {
    throw UsageError("a fluid of your own needs both --density and --viscosity");
  }
  if (isCustom && !flow.fluid.empty() && flow.fluid != "custom")
  {
    throw UsageError(
      "--fluid " + flow.fluid + " has its own density and viscosity: leave out one or the other");
  }
}

bool hasDetails(const FlowOptions& flow)
{
  return flow.length > 0 || flow.yPlus > 0 || flow.density > 0 || flow.viscosity > 0 || flow.lengthUnit > 0 ||
    !flow.fluid.empty() || !flow.law.empty() || flow.givesThickness;
}

void check(const Options& options)
{
  const FlowOptions& flow = options.flow;
  if (!flow.isGiven())
  {
    if (hasDetails(flow))
    {
      throw UsageError("flow conditions need --velocity or --reynolds");
    }
    return;
  }
  checkFluid(flow);
  checkName("--friction-law", flow.law, frictionLaws());
  if (flow.length == 0)
  {
    throw UsageError("--length is missing: the distance from the leading edge, in the unit of the surface");
  }
  if (options.firstHeight > 0)
  {
    throw UsageError(
      "--first-height and flow conditions: give one of them, the height follows from the flow");
  }
  if (flow.givesThickness && (options.thickness > 0 || options.layers > 0))
  {
    throw UsageError("--thickness-from-flow: leave out --thickness and --layers, they follow");
  }
}
} // namespace

const std::vector<std::string>& frictionLaws()
{
  static const std::vector<std::string> names = { "schlichting", "power-law", "schultz-grunow", "laminar" };
  return names;
}

int fluidOf(const FlowOptions& flow)
{
  const std::string name = flow.density > 0 ? "custom" : flow.fluid.empty() ? "air" : flow.fluid;
  return static_cast<int>(std::find(Fluids.begin(), Fluids.end(), name) - Fluids.begin());
}

int frictionLawOf(const FlowOptions& flow)
{
  const auto& names = frictionLaws();
  return flow.law.empty() ? 0
                          : static_cast<int>(std::find(names.begin(), names.end(), flow.law) - names.begin());
}

const OptionGroup& flowOptions()
{
  using O = Options;
  using A = Arguments;
  using S = const std::string;
  static const OptionGroup group = {
    {
      { "--velocity", [](O& o, A& a, S& name) { o.flow.velocity = positiveOf(a, name); } },
      { "--reynolds", [](O& o, A& a, S& name) { o.flow.reynoldsNumber = positiveOf(a, name); } },
      { "--length", [](O& o, A& a, S& name) { o.flow.length = positiveOf(a, name); } },
      { "--length-unit", [](O& o, A& a, S& name) { o.flow.lengthUnit = positiveOf(a, name); } },
      { "--y-plus", [](O& o, A& a, S& name) { o.flow.yPlus = positiveOf(a, name); } },
      { "--fluid", [](O& o, A& a, S& name) { o.flow.fluid = a.valueOf(name); } },
      { "--density", [](O& o, A& a, S& name) { o.flow.density = positiveOf(a, name); } },
      { "--viscosity", [](O& o, A& a, S& name) { o.flow.viscosity = positiveOf(a, name); } },
      { "--friction-law", [](O& o, A& a, S& name) { o.flow.law = a.valueOf(name); } },
      { "--thickness-from-flow", [](O& o, A&, S&) { o.flow.givesThickness = true; } },
    },
    check, R"(
Flow conditions, in place of a first height
  --velocity U          of the outer flow, m/s
  --reynolds RE         of the length, in place of velocity and fluid
  --length L            distance from the leading edge, in the unit of the surfaces; must be given
  --length-unit M       metres in one unit of the surfaces (1)
  --y-plus Y            of the first point above the wall (1); cell centres see half of it
  --fluid NAME          air (15 degrees C), water (fresh, 20 degrees C); air is taken
  --density, --viscosity  kg/m3 and Pa s (dynamic) of another fluid
  --friction-law NAME   schlichting, power-law, schultz-grunow or laminar; schlichting is taken
  --thickness-from-flow layers as thick together as the boundary layer at the length
)"
  };
  return group;
}
} // namespace commandline

#include "Arguments.h"

namespace commandline
{
namespace
{
bool describesLayers(const Options& options)
{
  return options.firstHeight > 0 || options.flow.isGiven() || options.growth > 0 || options.layers > 0 ||
    options.thickness > 0 || !options.walls.empty() || options.prisms;
}

void check(const Options& options)
{
  if (options.layers > 0 && options.thickness > 0)
  {
    throw UsageError("--layers and --thickness: give one of them, the other follows");
  }
  if (options.isotropicOnly && describesLayers(options))
  {
    throw UsageError("--isotropic-only makes no layers: leave out what describes them");
  }
  if (!options.isotropicOnly && options.firstHeight == 0 && !options.flow.isGiven())
  {
    throw UsageError("--first-height is missing: the first spacing normal to the walls, in the unit of the "
                     "surface (or --velocity or --reynolds, from which it follows, or --isotropic-only for a "
                     "mesh without layers)");
  }
}
} // namespace

const OptionGroup& layerOptions()
{
  using O = Options;
  using A = Arguments;
  using S = const std::string;
  static const OptionGroup group = {
    {
      { "--walls", [](O& o, A& a, S& name) { addValues(a, name, o.walls); } },
      { "--first-height", [](O& o, A& a, S& name) { o.firstHeight = positiveOf(a, name); } },
      { "--growth", [](O& o, A& a, S& name) { o.growth = positiveOf(a, name, 1); } },
      { "--layers", [](O& o, A& a, S& name) { o.layers = countOf(a, name); } },
      { "--thickness", [](O& o, A& a, S& name) { o.thickness = positiveOf(a, name); } },
      { "--prisms", [](O& o, A&, S&) { o.prisms = true; } },
      { "--isotropic-only", [](O& o, A&, S&) { o.isotropicOnly = true; } },
    },
    check, R"(
Layers
  --first-height H      first spacing normal to the walls; must be given, or follow from
                        flow conditions
  --growth G            ratio of successive spacings (1.2)
  --layers N            number of layers (25)
  --thickness T         thickness of all layers; their number follows
  --walls PATTERN...    the viscous walls by patch name, * and ? allowed (those of type wall or wake;
                        if no types are known, every patch that is not a side of a box); goes on to
                        the next option
  --prisms              layers of prisms (wedges, hexahedra in corners, pyramids where they end)
                        instead of tetrahedra
  --isotropic-only      stop after the first stage: no layers
)"
  };
  return group;
}
} // namespace commandline

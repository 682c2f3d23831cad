#include "Arguments.h"

namespace commandline
{
namespace
{
bool describesLayers(const Options& options)
{
  return options.firstHeight > 0 || options.flow.isGiven() || options.growth > 0 || options.layers > 0 ||
    options.thickness > 0 || !options.walls.empty() || options.prisms || !options.patchLayers.empty() ||
    options.columns.areGiven();
}

// PATCH=H, PATCH=H:G or PATCH=H:G:N
PatchLayersOption patchLayersOf(const std::string& word, const std::string& option)
{
  const auto [pattern, values] = assignmentOf(word, option, "PATCH=H, PATCH=H:G or PATCH=H:G:N");
  std::vector<std::string> parts = { "" };
  for (const char c : values)
  {
    if (c == ':')
    {
      parts.emplace_back();
      continue;
    }
    parts.back() += c;
  }
  Arguments numbers(parts);
  PatchLayersOption layers{ pattern, positiveOf(numbers, option) };
  layers.growth = numbers.atEnd() ? 0 : positiveOf(numbers, option, 1);
  layers.layers = numbers.atEnd() ? 0 : countOf(numbers, option);
  if (!numbers.atEnd())
  {
    throw UsageError(option + " needs PATCH=H, PATCH=H:G or PATCH=H:G:N, not " + word);
  }
  return layers;
}

void addPatchLayers(Options& options, Arguments& arguments, const std::string& option)
{
  for (const std::string& word : valuesOf(arguments, option))
  {
    options.patchLayers.push_back(patchLayersOf(word, option));
  }
}

// Patches of their own first height have their own number of layers: it cannot follow from one thickness.
void checkPatchLayers(const Options& options)
{
  const bool hasThickness = options.thickness > 0 || options.flow.givesThickness;
  for (const PatchLayersOption& layers : options.patchLayers)
  {
    if (hasThickness && layers.layers == 0)
    {
      throw UsageError("--patch-layers beside a thickness: give the number of layers, too, as in " +
        layers.pattern + "=1e-4:1.2:20");
    }
  }
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
  if (options.nonOrthogonality >= 0 && !options.prisms)
  {
    throw UsageError("--non-orthogonality belongs to --prisms: give that, too");
  }
  checkPatchLayers(options);
  const bool hasHeight = options.firstHeight > 0 || options.flow.isGiven() || !options.patchLayers.empty();
  if (!options.isotropicOnly && !hasHeight)
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
      { "--patch-layers", addPatchLayers },
      { "--constant-layers", [](O& o, A& a, S& name) { o.columns.constantLayers = countOf(a, name); } },
      { "--isotropic-fraction",
        [](O& o, A& a, S& name) { o.columns.isotropicFraction = positiveOf(a, name); } },
      { "--gap-fraction", [](O& o, A& a, S& name) { o.columns.gapFraction = positiveUpTo(a, name, 0.5); } },
      { "--normal-angle", [](O& o, A& a, S& name) { o.columns.normalAngle = positiveUpTo(a, name, 180); } },
      { "--fan-angle", [](O& o, A& a, S& name) { o.columns.fanAngle = numberBetween(a, name, 5, 180); } },
      { "--surface-angle",
        [](O& o, A& a, S& name) { o.columns.surfaceAngle = numberBetween(a, name, 0, 90); } },
      { "--non-orthogonality",
        [](O& o, A& a, S& name) { o.nonOrthogonality = numberBetween(a, name, 0, 90); } },
      { "--prisms", [](O& o, A&, S&) { o.prisms = true; } },
      { "--isotropic-only", [](O& o, A&, S&) { o.isotropicOnly = true; } },
    },
    check, R"(
Layers
  --first-height H      first spacing normal to the walls; must be given, or follow from
                        flow conditions, or be given for each wall
  --growth G            ratio of successive spacings (1.2)
  --layers N            number of layers (25)
  --thickness T         thickness of all layers; their number follows
  --walls PATTERN...    the viscous walls by patch name, * and ? allowed (those of type wall or wake;
                        if no types are known, every patch that is not a side of a box); goes on to
                        the next option
  --patch-layers PATCH=H[:G[:N]]...
                        layers of their own for patches (names, wildcards), which are the walls then, with
                        those of --walls: first height, growth, number (--growth, --layers)
  --constant-layers N   so many first layers are all of the first height (0)
  --isotropic-fraction F  layers end where their spacing exceeds F times the local edges (0.7)
  --gap-fraction F      layers end at F of the distance to the opposite surface, up to 0.5 (0.3)
  --normal-angle A      convex edges that turn by more than A degrees have a fan of columns (30)
  --fan-angle A         largest angle between columns of a fan, 5 to 180 degrees (30)
  --surface-angle A     surfaces that layers run into may turn by at most A degrees (10)
  --prisms              layers of prisms (wedges, hexahedra in corners, pyramids where they end)
                        instead of tetrahedra
  --non-orthogonality A points beyond prisms move where faces are less orthogonal than A degrees (70)
  --isotropic-only      stop after the first stage: no layers
)"
  };
  return group;
}
} // namespace commandline

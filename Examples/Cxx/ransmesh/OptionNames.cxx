#include "OptionNames.h"

#include <array>
#include <cctype>
#include <string_view>

namespace commandline
{
namespace
{
struct OptionName
{
  std::string_view parameter;
  std::string_view option;
};

constexpr std::array Names = {
  OptionName{ "AddWallPatch", "--walls" },
  OptionName{ "ConstantLayers", "--constant-layers" },
  OptionName{ "Density", "--density" },
  OptionName{ "EdgesAcrossGap", "--edges-across-gap" },
  OptionName{ "EdgesPerCircle", "--edges-per-circle" },
  OptionName{ "FanAngle", "--fan-angle" },
  OptionName{ "FarFieldMargins", "--far-field, --margin" },
  OptionName{ "FirstHeight", "--first-height" },
  OptionName{ "GapFraction", "--gap-fraction" },
  OptionName{ "GroundPosition", "--ground" },
  OptionName{ "GrowthRate", "--growth" },
  OptionName{ "ImproveSurfaceTriangles off", "--swap-angle 0" },
  OptionName{ "IsotropicFraction", "--isotropic-fraction" },
  OptionName{ "KeepInside", "--keep-inside" },
  OptionName{ "LargestHole", "--fill-holes" },
  OptionName{ "LengthUnit", "--length-unit" },
  OptionName{ "MaximumEdgeLength", "--size" },
  OptionName{ "MaximumSurfaceDeviation", "--surface-deviation" },
  OptionName{ "NormalAngle", "--normal-angle" },
  OptionName{ "NumberOfLayers", "--layers" },
  OptionName{ "ReferenceLength", "--length" },
  OptionName{ "ReynoldsNumber", "--reynolds" },
  OptionName{ "SetPatchEdgeLength", "--surface-size" },
  OptionName{ "SetPatchType", "--patch-type" },
  OptionName{ "ShortestEdge", "--shortest-edge" },
  OptionName{ "SmallestSurfaceEdgeLength", "--smallest-size" },
  OptionName{ "SurfaceEdgeLength", "--surface-size" },
  OptionName{ "SurfaceGrowthRate", "--size-growth" },
  OptionName{ "SymmetryPlane", "--symmetry-plane" },
  OptionName{ "SymmetryPosition", "--symmetry-plane" },
  OptionName{ "ThicknessFromFlow", "--thickness-from-flow" },
  OptionName{ "TotalThickness", "--thickness" },
  OptionName{ "Velocity", "--velocity" },
  OptionName{ "Viscosity", "--viscosity" },
  OptionName{ "WaterlinePlane", "--waterline" },
  OptionName{ "WaterlinePosition", "--waterline" },
  OptionName{ "WeldTolerance", "--weld" },
  OptionName{ "WorkerMemoryLimit", "--memory-limit" },
  OptionName{ "WorkerTimeLimit", "--time-limit" },
  OptionName{ "YPlus", "--y-plus" },
};

// A name in quotes is the user's.
bool isPartOfWord(const std::string& text, std::size_t at)
{
  return at < text.size() &&
    (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_' || text[at] == '\'');
}

// Where the word ends, or npos.
std::size_t endOfWord(const std::string& text, std::string_view word)
{
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
  {
    const std::size_t end = at + word.size();
    if (!isPartOfWord(text, end) && (at == 0 || !isPartOfWord(text, at - 1)))
    {
      return end;
    }
  }
  return std::string::npos;
}

void addOption(const OptionName& name, std::string& message)
{
  const std::size_t end = endOfWord(message, name.parameter);
  if (end == std::string::npos || message.find(name.option) != std::string::npos)
  {
    return;
  }
  const bool isAside = end < message.size() && message[end] == ')';
  const std::string option(name.option);
  message.insert(end, isAside ? ", " + option : " (" + option + ")");
}
} // namespace

std::string withOptionNames(const std::string& message, bool ofLayers)
{
  std::string text = message;
  for (const OptionName& name : Names)
  {
    addOption(name, text);
  }
  addOption({ "MaximumSurfaceAngle", ofLayers ? "--surface-angle" : "--swap-angle" }, text);
  return text;
}
} // namespace commandline

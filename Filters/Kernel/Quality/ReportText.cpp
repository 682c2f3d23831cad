#include "Quality/ReportText.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace ransmesh
{
namespace
{
constexpr std::size_t PatchesShown = 12; // more would not fit a screen

template <class... Values>
std::string format(const char* pattern, Values... values)
{
  std::array<char, 256> buffer{};
  std::snprintf(buffer.data(), buffer.size(), pattern, values...);
  return buffer.data();
}

std::string shortened(const std::string& name, std::size_t width)
{
  return name.size() <= width ? name : name.substr(0, width - 3) + "...";
}

std::string row(const char* what, const std::vector<std::string>& values)
{
  std::string line = format("  %-34s", what);
  for (const std::string& value : values)
  {
    line += format("%10s", value.c_str());
  }
  return line + "\n";
}

std::string row(const char* what, const Quantiles& q)
{
  std::vector<std::string> values;
  for (const std::size_t i : { 0, 1, 3, 5, 6, 7 }) // min, 1 %, median, 99 %, 99.9 %, max
  {
    values.push_back(q.count > 0 ? format("%.4g", q.at[i]) : "-");
  }
  return row(what, values);
}

std::string quantileHeading(const char* what)
{
  return row(what, std::vector<std::string>{ "min", "1 %", "median", "99 %", "99.9 %", "max" });
}

std::string percent(double share)
{
  // Neither all nor none unless it is exactly so.
  if (share > 0 && share < 1e-5)
  {
    return "<0.001 %";
  }
  if (share < 1 && share > 0.99999)
  {
    return ">99.999 %";
  }
  return format(share > 0.99 && share < 1 ? "%.3f %%" : "%.3g %%", 100 * share);
}

std::string more(std::size_t hidden)
{
  return hidden > 0 ? format("      ... and %zu more\n", hidden) : "";
}

std::string allFaults(const QualityReport& report)
{
  const std::string ofPrisms = report.prisms ? report.prisms->faults : "";
  const std::string ofTets = report.faults.none() ? "" : report.faults.text();
  return ofPrisms + (!ofPrisms.empty() && !ofTets.empty() ? "; cut into tetrahedra: " : "") + ofTets;
}

std::string prismText(const QualityReport& report)
{
  if (!report.prisms)
  {
    return "";
  }
  const PrismSummary& prisms = *report.prisms;
  const std::string hexahedra = prisms.hexahedra > 0 ? format(", %zu hexahedra", prisms.hexahedra) : "";
  return format(
           "  %zu tetrahedra, %zu pyramids, %zu wedges%s (%s of the layers), %zu boundary quadrilaterals;\n",
           prisms.tetrahedra, prisms.pyramids, prisms.wedges, hexahedra.c_str(),
           percent(prisms.shareOfLayers).c_str(), prisms.quadrilaterals) +
    "  all below: of the tetrahedra that they are cut into\n";
}

std::string meshText(const QualityReport& report)
{
  std::string text = report.isValid
    ? "Mesh: VALID (exactly: every tetrahedron positive, every face matched, no points twice or unused)\n"
    : "Mesh: INVALID: " + allFaults(report) + "\n";
  return text + prismText(report) +
    format("  %zu points, %zu tetrahedra, %zu boundary triangles", report.points, report.tetrahedra,
      report.triangles) +
    (report.isMeasured ? format(", volume %.6g\n", report.volume) : "\n");
}

std::string patchesText(const std::vector<PatchSummary>& patches)
{
  std::string text = format("\n  %5s %-28s %-10s %14s %14s\n", "", "patch", "type", "triangles", "area");
  for (std::size_t i = 0; i < std::min(patches.size(), PatchesShown); ++i)
  {
    const PatchSummary& patch = patches[i];
    text += format("  %5d %-28s %-10s %14zu %14.6g\n", patch.number, shortened(patch.name, 28).c_str(),
      (std::string(nameOf(patch.type)) + (patch.isSheet ? " sheet" : "")).c_str(), patch.triangles,
      patch.area);
  }
  return text + more(patches.size() - std::min(patches.size(), PatchesShown));
}

std::string regionsText(const std::vector<RegionSummary>& regions)
{
  if (regions.empty())
  {
    return "";
  }
  std::string text = format("\n  %5s %-39s %14s %14s\n", "", "region", "tetrahedra", "volume");
  for (std::size_t i = 0; i < std::min(regions.size(), PatchesShown); ++i)
  {
    const RegionSummary& region = regions[i];
    text += format("  %5d %-39s %14zu %14.6g\n", region.number, shortened(region.name, 39).c_str(),
      region.tetrahedra, region.volume);
  }
  return text + more(regions.size() - std::min(regions.size(), PatchesShown));
}

std::string cellsText(const QualityReport& report)
{
  std::string text = "\n" + quantileHeading("tetrahedra (length unit: the mesh's)");
  text += row("volume", report.cellVolume);
  text += row("longest edge", report.longestEdge);
  text += row("shortest edge", report.shortestEdge);
  text += row("stretching: longest edge / height", report.all.stretching);
  text += row("quality (1: regular)", report.all.quality);
  text += row("smallest dihedral angle, degrees", report.all.smallestDihedral);
  text += row("largest dihedral angle, degrees", report.all.largestDihedral);
  if (report.layers.count > 0)
  {
    text += row("the same in layers", report.layers.largestDihedral);
  }
  return text;
}

std::string sharesText(const QualityReport& report)
{
  const auto shares = [](const char* what, const ShapeSummary& shapes)
  {
    std::vector<std::string> values;
    values.reserve(shapes.shareOver.size());
    for (const double share : shapes.shareOver)
    {
      values.push_back(percent(share));
    }
    return row(what, values);
  };
  std::vector<std::string> limits;
  limits.reserve(ShapeSummary::Limits.size());
  for (const double limit : ShapeSummary::Limits)
  {
    limits.push_back(format("%g", limit));
  }
  std::string text =
    row("share with a dihedral angle over", limits) + shares("of all tetrahedra", report.all);
  if (report.layers.count > 0)
  {
    text += shares(format("of %zu in layers", report.layers.count).c_str(), report.layers);
  }
  return "\n" + text;
}

std::string wallRow(const WallSummary& wall)
{
  const std::string asked = wall.patch == 0
    ? format("%22s", "")
    : format("%10.4g %5.4g %5d", wall.asked.firstHeight, wall.asked.growthRate, wall.asked.numberOfLayers);
  return format("  %-18s%s %9s %9zu %7.2f %10s %10s\n",
    wall.patch == 0 ? "all walls" : shortened(wall.name, 18).c_str(), asked.c_str(),
    percent(wall.areaShareWithFirstHeight).c_str(), wall.smoothPoints, wall.meanLayers,
    percent(wall.shareFull).c_str(), percent(wall.shareEmpty).c_str());
}

std::string stopsText(const std::vector<StopCount>& stops)
{
  std::string text;
  for (const StopCount& stop : stops)
  {
    text += (text.empty() ? "  columns that stopped early: " : ", ") + stop.reason + " " +
      std::to_string(stop.columns);
  }
  return text.empty() ? text : text + "\n";
}

std::string wallsText(const QualityReport& report)
{
  if (report.walls.empty())
  {
    return "\n  Layers: none were asked for\n";
  }
  std::string text = format("\n  %-18s%10s %5s %5s %9s %9s %7s %10s %10s\n", "layers asked", "h0", "grow",
    "n", "h0 met", "columns", "layers", "full", "empty");
  const std::size_t shown = std::min(report.walls.size(), PatchesShown);
  for (std::size_t i = report.walls.size() == 2 ? 1 : 0; i < shown; ++i) // one wall is all walls
  {
    text += wallRow(report.walls[i]);
  }
  text += more(report.walls.size() - shown);
  text += format("  (h0 met: share of the area, within a factor of %g; columns: from smooth wall points)\n",
    report.options.columns.tolerance);
  if (std::any_of(
        report.patches.begin(), report.patches.end(), [](const PatchSummary& p) { return p.isSheet; }))
  {
    text += "  (sheets count with both sides: their area and their points twice)\n";
  }
  text += stopsText(report.stops);
  const WallSummary& all = report.walls.front();
  text += "\n" + quantileHeading("layers found");
  text += row("first height / asked", all.firstHeightRatio);
  text += row("growth: spacing / the one below", all.growth);
  text += row("lean from the wall's normal, degrees", all.lean);
  text += row("edge beyond the top / last spacing", all.transition);
  return text + row("last spacing / edge of the wall", all.topToWallEdge);
}
} // namespace

std::string reportText(const QualityReport& report)
{
  std::string text = meshText(report);
  if (!report.isMeasured)
  {
    return text + "  Nothing else can be measured on it.\n";
  }
  return text + patchesText(report.patches) + regionsText(report.regions) + cellsText(report) +
    sharesText(report) + wallsText(report);
}
} // namespace ransmesh

#include "Surface/Remedy.h"

#include "Surface/Borders.h"
#include "Surface/Repair.h"
#include "Surface/Stitching.h"
#include "Surface/TopologyFaults.h"
#include "Surface/Welding.h"
#include "Surface/Wrapping.h"
#include "Triangles/SurfaceRepair.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace ransmesh
{
namespace
{
// More holes are no holes that somebody wants filled.
constexpr std::size_t MostHoles = 200;

constexpr double NearlyInPlane = 1e-6; // of the largest extent

std::string numberText(double x)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", x);
  return text;
}

// With two digits, not below x.
double roundedUp(double x)
{
  const double unit = std::pow(10, std::floor(std::log10(x)) - 1);
  return std::ceil(x / unit * (1 + 1e-9)) * unit;
}

bool heals(const SurfaceMesh& surface, PatchTable patches, const RepairOptions& options)
{
  SurfaceMesh trial = surface;
  repairSurface(trial, patches, options);
  DiagnosisOptions topology;
  topology.intersections = false;
  topology.closedBy = options.closedBy;
  const Context silent;
  if (!diagnose(trial, topology, silent).isSound())
  {
    return false;
  }
  DiagnosisOptions all = topology;
  all.intersections = true;
  all.nearTolerance = 0;
  return diagnose(trial, all, silent).isSound();
}

// The gaps that may be welded: rims with the same points, and rims with different ones.
std::vector<double> weldTolerances(const SurfaceMesh& surface)
{
  std::vector<double> tolerances;
  for (const double width : { widthOfGaps(surface), widthOfUnequalGaps(surface) })
  {
    if (width > 0)
    {
      tolerances.push_back(roundedUp(width));
    }
  }
  std::sort(tolerances.begin(), tolerances.end());
  return tolerances;
}

// Holes to be filled after welding.
struct Filling
{
  RepairOptions options;
  std::size_t holes = 0;
  std::vector<Vector3> rims;
};

Filling fillingAfter(SurfaceMesh surface, PatchTable patches, const RepairOptions& welding)
{
  repairSurface(surface, patches, welding);
  const std::vector<BorderLoop> borders = findBorders(surface);
  Filling filling;
  filling.options = welding;
  double size = 0;
  for (const BorderLoop& border : borders)
  {
    const bool isHole = !holdEdge(welding.closedBy, border.extent.low, border.extent.high);
    filling.holes += isHole;
    size = std::max(size, isHole ? border.extent.largestLength() : 0);
    for (const Index v : border.points)
    {
      filling.rims.push_back(surface.points[v]);
    }
  }
  filling.options.largestHole = size > 0 && borders.size() <= MostHoles ? roundedUp(size) : 0;
  return filling;
}

std::string textOf(const RepairOptions& options, std::size_t holes)
{
  const std::string weld = numberText(options.weldTolerance);
  const std::string hole = numberText(options.largestHole);
  const std::string fill = "fill " + (holes == 1 ? "the hole" : "the " + std::to_string(holes) + " holes") +
    ": set LargestHole to " + hole;
  if (options.weldTolerance < 0)
  {
    return fill + " (ransmesh --fill-holes " + hole + ")";
  }
  const std::string gaps = "weld the gaps: set WeldTolerance to " + weld;
  return options.largestHole > 0
    ? gaps + ", and " + fill + " (ransmesh --weld " + weld + " --fill-holes " + hole + ")"
    : gaps + " (ransmesh --weld " + weld + ")";
}

// Open edges that all lie in a plane across an axis may be meant: half models end so.
std::string otherMeaning(const Filling& filling, const SurfaceMesh& surface)
{
  const double tolerance = NearlyInPlane * extentOf(surface.points).largestLength();
  const Extent rims = extentOf(filling.rims);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (rims.length(axis) <= tolerance && rims.largestLength() > tolerance)
    {
      const std::string place = std::string(1, "xyz"[axis]) + "=" + numberText(rims.low[axis]);
      return ". Or, if half a model ends there, or a hull at its waterline, leave it open: set SymmetryPlane "
             "(ransmesh --symmetry-plane " +
        place + ") or WaterlinePlane";
    }
  }
  return "";
}

// Tries the repairs that are not done by themselves: the least of them that heals.
std::string workingRepair(
  const SurfaceMesh& surface, const PatchTable& patches, const std::vector<AxisPlane>& closedBy)
{
  SurfaceMesh merged = surface;
  mergeEqualPoints(merged);
  RepairOptions options;
  options.closedBy = closedBy;
  std::vector<double> tolerances = weldTolerances(merged);
  for (const double tolerance : tolerances)
  {
    options.weldTolerance = tolerance;
    if (heals(merged, patches, options))
    {
      return textOf(options, 0);
    }
  }
  tolerances.insert(tolerances.begin(), AutomaticTolerance);
  std::vector<Filling> fillings;
  for (const double tolerance : tolerances)
  {
    options.weldTolerance = tolerance;
    fillings.push_back(fillingAfter(surface, patches, options));
  }
  // Smaller holes first: what is left open between two parts is no hole to be filled in each of them.
  std::stable_sort(fillings.begin(), fillings.end(),
    [](const Filling& f, const Filling& g) { return f.options.largestHole < g.options.largestHole; });
  for (const Filling& filling : fillings)
  {
    if (filling.options.largestHole > 0 && heals(surface, patches, filling.options))
    {
      return textOf(filling.options, filling.holes) + otherMeaning(filling, surface);
    }
  }
  return "";
}

std::string wrapping(const SurfaceMesh& surface)
{
  const std::string alpha = numberText(proposedAlpha(surface));
  return "wrap it by vtkSurfaceWrap with an Alpha of " + alpha + " (ransmesh --wrap " + alpha + ")";
}

// What has open edges, where the rest is closed without it, may be meant as a sheet.
std::string sheetMeaning(
  const SurfaceMesh& surface, const PatchTable& patches, const std::vector<AxisPlane>& closedBy)
{
  SurfaceMesh merged = surface;
  mergeEqualPoints(merged);
  std::vector<char> isOpen(patches.size(), 0);
  for (const SurfaceFinding& finding : findOpenEdges(merged, closedBy).findings)
  {
    isOpen[merged.patch[finding.triangle]] = 1;
  }
  std::vector<char> stays;
  for (const int patch : merged.patch)
  {
    stays.push_back(!isOpen[patch]);
  }
  SurfaceMesh rest = std::move(merged);
  keepTriangles(rest, stays);
  const auto count = std::count(isOpen.begin(), isOpen.end(), 1);
  if (rest.triangles.empty() || findOpenEdges(rest, closedBy).count > 0 || count > 1)
  {
    return "";
  }
  const auto patch = std::find(isOpen.begin(), isOpen.end(), 1) - isOpen.begin();
  return ". Or, if '" + patches[patch].name +
    "' is a wake or a wall without thickness, take it out and give it as a sheet by the second input "
    "(ransmesh --wake)";
}
} // namespace

std::string proposeRemedy(const SurfaceMesh& surface, const PatchTable& patches, const Diagnosis& diagnosis,
  const std::vector<AxisPlane>& closedBy)
{
  if (diagnosis.find(SurfaceFault::NotFinite))
  {
    return "repair the file or the filter that made it";
  }
  RepairOptions usual;
  usual.closedBy = closedBy;
  if (heals(surface, patches, usual))
  {
    return "the usual repairs do it: leave Repair on, or take vtkSurfaceRepair";
  }
  if (diagnosis.find(SurfaceFault::OpenEdge))
  {
    const std::string repair = workingRepair(surface, patches, closedBy);
    return !repair.empty() ? repair
                           : "close the surface where it was made, or " + wrapping(surface) +
        sheetMeaning(surface, patches, closedBy);
  }
  if (diagnosis.find(SurfaceFault::Intersection))
  {
    return "separate the parts or unite them in the CAD system, or " + wrapping(surface);
  }
  return "clean or remesh the surface where it was made, or " + wrapping(surface);
}
} // namespace ransmesh

#include "Layers/LayerPlanning.h"

#include "Geometry/Extent.h"
#include "Support/Numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ransmesh
{
namespace
{
bool wildcardMayTake(PatchType type)
{
  return type == PatchType::Wall || type == PatchType::Wake || type == PatchType::Patch;
}

bool hasWildcard(std::string_view pattern)
{
  return pattern.find_first_of("*?") != std::string_view::npos;
}

std::string listOfNames(const PatchTable& patches)
{
  std::string out;
  constexpr std::size_t shown = 20;
  for (std::size_t i = 1; i < patches.size() && i <= shown; ++i)
  {
    out += (i > 1 ? ", " : "") + patches[i].name + " (" + std::string(nameOf(patches[i].type)) + ")";
  }
  return patches.size() > shown + 1 ? out + ", ..." : out;
}

// Fewer of them apart, a level's height is right to a tenth no more.
constexpr int LeastSpacings = 5;

// The distance from the number to the next larger one.
double spacingAt(double number)
{
  return std::nextafter(number, std::numeric_limits<double>::infinity()) - number;
}

// Of each patch's points, without sign; by patch number.
std::vector<double> largestCoordinates(const MeshData& mesh, std::size_t patchCount)
{
  std::vector<double> largest(patchCount, 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (const Index v : mesh.triangles[t])
    {
      const Vector3& p = mesh.points[v];
      double& most = largest[mesh.trianglePatch[t]];
      most = std::max({ most, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z) });
    }
  }
  return largest;
}

// The walls, by number, where none is named.
std::vector<int> wallsByType(const MeshData& mesh, const PatchTable& patches)
{
  std::vector<int> walls;
  bool typesKnown = false;
  for (std::size_t i = 1; i < patches.size(); ++i)
  {
    const PatchType type = patches[i].type;
    typesKnown = typesKnown || (type != PatchType::Patch && type != PatchType::Wake);
    if (type == PatchType::Wall || type == PatchType::Wake)
    {
      walls.push_back(static_cast<int>(i));
    }
  }
  if (typesKnown)
  {
    return walls;
  }
  const std::vector<char> isSide = findBoxSides(mesh, patches.size());
  for (std::size_t i = 1; i < patches.size(); ++i)
  {
    if (!isSide[i])
    {
      walls.push_back(static_cast<int>(i));
    }
  }
  return walls;
}

LayerSpecification specificationFor(int patch, const PatchTable& patches, const LayerRequest& request)
{
  LayerSpecification s = generalSpecification(request);
  for (const PatchLayers& rule : request.patchLayers)
  {
    const std::vector<int> taken = patchesOf(patches, rule.pattern);
    if (std::find(taken.begin(), taken.end(), patch) != taken.end())
    {
      s.firstHeight = rule.firstHeight;
      s.growthRate = rule.growthRate;
      s.numberOfLayers = rule.numberOfLayers;
    }
  }
  return s;
}
} // namespace

LayerSpecification generalSpecification(const LayerRequest& request)
{
  LayerSpecification s = request.general;
  if (request.totalThickness > 0)
  {
    s.numberOfLayers = layersForThickness(s, request.totalThickness);
  }
  return s;
}

bool matchesPattern(std::string_view name, std::string_view pattern)
{
  std::size_t n = 0;
  std::size_t p = 0;
  std::size_t star = std::string_view::npos;
  std::size_t resume = 0;
  while (n < name.size())
  {
    if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n]) && pattern[p] != '*')
    {
      ++n;
      ++p;
    }
    else if (p < pattern.size() && pattern[p] == '*')
    {
      star = p++;
      resume = n;
    }
    else if (star != std::string_view::npos)
    {
      p = star + 1;
      n = ++resume;
    }
    else
    {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

std::vector<int> patchesOf(const PatchTable& patches, const std::string& pattern)
{
  std::vector<int> taken;
  for (std::size_t i = 1; i < patches.size(); ++i)
  {
    const bool named = patches[i].name == pattern || std::to_string(i) == pattern;
    const bool byWildcard =
      hasWildcard(pattern) && wildcardMayTake(patches[i].type) && matchesPattern(patches[i].name, pattern);
    if (named || byWildcard)
    {
      taken.push_back(static_cast<int>(i));
    }
  }
  return taken;
}

std::vector<char> findBoxSides(const MeshData& mesh, std::size_t patchCount)
{
  const Extent box = extentOf(mesh.points);
  // For each patch and each of the six sides: do all points lie in it?
  std::vector<std::array<char, 6>> inSide(patchCount, { 1, 1, 1, 1, 1, 1 });
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    auto& sides = inSide[mesh.trianglePatch[t]];
    for (const Index v : mesh.triangles[t])
    {
      for (int i = 0; i < 3; ++i)
      {
        const double tolerance = 1e-9 * (box.high[i] - box.low[i]);
        sides[2 * i] = sides[2 * i] && mesh.points[v][i] - box.low[i] <= tolerance;
        sides[2 * i + 1] = sides[2 * i + 1] && box.high[i] - mesh.points[v][i] <= tolerance;
      }
    }
  }
  std::vector<char> isSide(patchCount, 0);
  for (std::size_t i = 0; i < patchCount; ++i)
  {
    isSide[i] = std::any_of(inSide[i].begin(), inSide[i].end(), [](char all) { return all != 0; });
  }
  return isSide;
}

Outcome findWalls(
  const MeshData& mesh, const PatchTable& patches, const LayerRequest& request, std::vector<char>& isWall)
{
  isWall.assign(patches.size(), 0);
  const auto take = [&](const std::string& pattern)
  {
    const std::vector<int> taken = patchesOf(patches, pattern);
    for (const int i : taken)
    {
      isWall[i] = 1;
    }
    return taken.empty() ? Outcome::badInput("no patch is taken by the wall pattern \"" + pattern +
                             "\"; the patches are: " + listOfNames(patches))
                         : Outcome::done();
  };
  for (const std::string& pattern : request.wallPatterns)
  {
    if (Outcome outcome = take(pattern); !outcome.ok())
    {
      return outcome;
    }
  }
  for (const PatchLayers& rule : request.patchLayers)
  {
    if (Outcome outcome = take(rule.pattern); !outcome.ok())
    {
      return outcome;
    }
  }
  if (request.wallPatterns.empty() && request.patchLayers.empty())
  {
    for (const int i : wallsByType(mesh, patches))
    {
      isWall[i] = 1;
    }
  }
  for (const auto& [name, chosen] : request.choices)
  {
    for (std::size_t i = 1; i < patches.size(); ++i)
    {
      isWall[i] = patches[i].name == name ? static_cast<char>(chosen) : isWall[i];
    }
  }
  if (std::none_of(isWall.begin(), isWall.end(), [](char w) { return w != 0; }))
  {
    return Outcome::badInput(
      "no patch is a viscous wall: name the walls with AddWallPatch, or give patches the type "
      "wall; the patches are: " +
      listOfNames(patches));
  }
  return Outcome::done();
}

Outcome planLayers(
  const MeshData& mesh, const PatchTable& patches, const LayerRequest& request, LayerPlan& plan)
{
  std::vector<char> isWall;
  if (Outcome outcome = findWalls(mesh, patches, request, isWall); !outcome.ok())
  {
    return outcome;
  }
  const double extent = extentOf(mesh.points).largestLength();
  const std::vector<double> largest = largestCoordinates(mesh, patches.size());
  plan.assign(patches.size(), LayerSpecification{});
  for (std::size_t i = 1; i < patches.size(); ++i)
  {
    if (!isWall[i])
    {
      continue;
    }
    plan[i] = specificationFor(static_cast<int>(i), patches, request);
    if (Outcome outcome = checkSpecification(plan[i], patches[i].name.c_str()); !outcome.ok())
    {
      return outcome;
    }
    const std::string where =
      "layers on " + patches[i].name + ": the first height " + textOf(plan[i].firstHeight);
    if (!(plan[i].firstHeight < extent))
    {
      return Outcome::badInput(where + " is not below the largest extent of the mesh, " + textOf(extent) +
        ": give FirstHeight in the length unit of the surface");
    }
    if (const double coordinate = largest[i]; plan[i].firstHeight < LeastSpacings * spacingAt(coordinate))
    {
      return Outcome::badInput(where + " is less than " + std::to_string(LeastSpacings) +
        " times the distance of neighbouring numbers at the wall's coordinates, which go up to " +
        textOf(coordinate) +
        ": give FirstHeight in the length unit of the surface, or move the body to the origin");
    }
  }
  return Outcome::done();
}

std::vector<char> changeablePatches(const PatchTable& patches, const LayerPlan& plan)
{
  std::vector<char> changeable(patches.size(), 0);
  for (std::size_t p = 1; p < patches.size(); ++p)
  {
    const bool hasLayers = p < plan.size() && plan[p].hasLayers();
    changeable[p] = !hasLayers && patches[p].type != PatchType::Interface;
  }
  return changeable;
}

PatchTable withFrozenSheets(const PatchTable& patches, const std::vector<int>& sheetPatches)
{
  PatchTable opened = patches;
  for (const int p : sheetPatches)
  {
    opened[p].type = PatchType::Interface;
  }
  return opened;
}

PatchTable patchesOfOpened(
  const PatchTable& patches, const std::vector<int>& sheetPatches, const LayerPlan& plan)
{
  PatchTable opened = patches;
  for (const int p : sheetPatches)
  {
    opened[p].type = plan[p].hasLayers() ? PatchType::Wake : PatchType::Interface;
  }
  return opened;
}
} // namespace ransmesh

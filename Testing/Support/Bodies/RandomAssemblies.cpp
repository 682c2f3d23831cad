#include "Bodies/RandomAssemblies.h"

#include "Bodies/RandomParts.h"
#include "Bodies/SurfaceBuilder.h"
#include "Remeshing/SurfaceRemeshing.h"
#include "Surface/Preparation.h"
#include "Triangles/FeatureSplit.h"
#include "Triangles/SurfaceTriangles.h"

#include <CGAL/Polygon_mesh_processing/corefinement.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace bodies
{
namespace
{
using ransmesh::PatchTable;
namespace Processing = CGAL::Polygon_mesh_processing;

Facets randomFacets(Dice& dice)
{
  const double height = dice.between(0.1, 0.8);
  const double a = dice.between(0.15, 0.6);
  switch (dice.upTo(6))
  {
    case 0:
      return prism(4, a, dice.between(0.15, 0.6), height);
    case 1: // a cone or a pyramid
      return prism(dice.upTo(2) == 0 ? 24 : 3 + dice.upTo(4), a, a, height, 0);
    case 2: // part of one
      return prism(dice.upTo(2) == 0 ? 24 : 3 + dice.upTo(4), a, a, height, dice.between(0.1, 0.9));
    case 3: // a wedge: two of three ridges are acute
      return prism(3, a, dice.between(0.1, 0.5) * a, height);
    case 4: // a plate
      return prism(4, a, height, dice.between(0.01, 0.06));
    default:
      return ball(a, 9, 18);
  }
}

Solid placed(Dice& dice, Facets facets, double reach)
{
  const Frame frame = dice.upTo(2) == 0 ? Frame{} : randomFrame(dice);
  const Vector3 place = dice.between(0, reach) * dice.direction();
  for (Vector3& p : facets.points)
  {
    p = frame(p) + place;
  }
  return solidOf(facets);
}

// A long rod makes a hole right through; a thin plate makes a slot, or two bodies side by side.
Facets randomTool(Dice& dice)
{
  return dice.upTo(2) == 0
    ? prism(dice.upTo(2) == 0 ? 4 : 16, dice.between(0.04, 0.2), dice.between(0.04, 0.2), 3)
    : prism(4, 3, dice.between(0.2, 3), dice.between(0.005, 0.1));
}

Solid randomSolid(Dice& dice)
{
  Solid solid = placed(dice, randomFacets(dice), 0.5);
  for (int parts = dice.upTo(3); parts > 0; --parts)
  {
    Solid other = placed(dice, randomFacets(dice), 0.7);
    Solid together;
    if (Processing::corefine_and_compute_union(solid, other, together))
    {
      solid = together;
    }
  }
  for (int tools = dice.upTo(3); tools > 0; --tools)
  {
    Solid tool = placed(dice, randomTool(dice), 0.3);
    Solid rest;
    if (Processing::corefine_and_compute_difference(solid, tool, rest) && rest.number_of_faces() > 0)
    {
      solid = rest;
    }
  }
  for (int cuts = dice.upTo(2); cuts > 0; --cuts)
  {
    cutByRandomPlane(dice, solid);
  }
  solid.collect_garbage();
  return solid;
}

// Six of ten are walls, and one at least.
void chooseTypes(Dice& dice, PatchTable& patches)
{
  constexpr PatchType others[] = { PatchType::Symmetry, PatchType::Symmetry, PatchType::Inlet,
    PatchType::Outlet };
  bool someWall = false;
  for (std::size_t i = 1; i < patches.size(); ++i)
  {
    const bool isWall = dice.upTo(10) < 6 || (i + 1 == patches.size() && !someWall);
    someWall = someWall || isWall;
    patches[i].type = isWall ? PatchType::Wall : others[dice.upTo(4)];
    patches[i].name = std::string(ransmesh::nameOf(patches[i].type)) + "_" + std::to_string(i);
  }
}

void chooseLayers(Dice& dice, RandomAssembly& result)
{
  Layers& layers = result.layers;
  const int kind = dice.upTo(8);
  layers.number = kind == 0 ? 1 + dice.upTo(2) : kind == 1 ? 60 + dice.upTo(60) : 3 + dice.upTo(28);
  layers.growth = dice.between(1, 1.5);
  const bool isThin = dice.upTo(4) == 0;
  layers.firstHeight = 1;
  layers.firstHeight =
    isThin ? 1e-7 * result.scale : result.size * std::pow(10, dice.between(-1.5, 0.5)) / layers.thickness();
}

// Leaves out the lowest levels, which coordinates up to reach could not tell, a tenth of them on some wall.
void keepToResolved(Layers& layers, double reach)
{
  constexpr double least = 2e-14;
  while (layers.number > 1 && layers.firstHeight < least * reach)
  {
    --layers.number;
    layers.firstHeight *= layers.growth;
  }
}

// A third of the walls get their own.
void choosePatchLayers(Dice& dice, RandomAssembly& result)
{
  for (const ransmesh::Patch& patch : result.body.patches)
  {
    if (patch.type == PatchType::Wall)
    {
      result.walls.push_back(patch.name);
      if (dice.upTo(3) == 0)
      {
        result.patchLayers.push_back(
          { patch.name, std::pow(10, dice.between(-1, 1)), dice.between(1, 1.5), 1 + dice.upTo(30) });
      }
    }
  }
}

// A wake or a fin without thickness, beside the body.
Body randomSheet(Dice& dice, double size)
{
  SurfaceBuilder builder;
  const bool isWake = dice.upTo(2) == 0;
  const int patch = builder.patch(isWake ? "wake" : "fin_wall", isWake ? PatchType::Wake : PatchType::Wall);
  const Frame frame = randomFrame(dice);
  const Vector3 corner = frame(Vector3{ -0.3, -0.3, dice.between(1.5, 2) });
  const int n = divisions(0.6, size);
  std::vector<Row> rows;
  for (int i = 0; i <= n; ++i)
  {
    const Vector3 first = corner + 0.6 * i / n * frame.x;
    rows.push_back(straightRow(first, first + 0.6 * frame.y, n));
  }
  builder.grid(rows, patch);
  return builder.finish(false);
}

void place(ransmesh::SurfaceMesh& surface, double scale, const Vector3& offset)
{
  for (Vector3& p : surface.points)
  {
    p = scale * (p + offset);
  }
}
} // namespace

RandomAssembly randomAssembly(std::uint32_t seed)
{
  Dice dice(seed);
  RandomAssembly result;
  Body& body = result.body;
  body.patches = { { "fluid", PatchType::Patch }, { "body_wall", PatchType::Wall } };
  body.farField = dice.upTo(2) == 0;
  const double size = dice.between(0.06, 0.2);
  const double scale = std::pow(10, dice.between(-3, 6));
  ransmesh::SurfaceMesh surface = toSurface(randomSolid(dice));
  ransmesh::RemeshingOptions options;
  options.length = size;
  ransmesh::RemeshingReport report;
  if (!remeshSurface(surface, options, report).ok() ||
    !prepareSurface(surface, body.patches, {}, {}).outcome.ok())
  {
    return result;
  }
  splitByAngle(surface, body.patches, 1, 30);
  if (!body.farField)
  {
    chooseTypes(dice, body.patches);
  }
  else if (dice.upTo(4) == 0)
  {
    body.sheets.push_back(randomSheet(dice, size));
  }
  result.scale = scale;
  result.size = size * scale;
  chooseLayers(dice, result);
  if (dice.upTo(3) == 0)
  {
    choosePatchLayers(dice, result);
  }
  const Vector3 offset =
    dice.upTo(4) == 0 ? std::pow(10, dice.between(0, 4)) * dice.direction() : Vector3{ 0, 0, 0 };
  if (body.farField && body.sheets.empty() && dice.upTo(3) == 0)
  {
    result.symmetryPlace = scale * (dice.between(-0.2, 0.2) + offset.z);
  }
  keepToResolved(result.layers, scale * (1 + norm(offset)));
  place(surface, scale, offset);
  body.surface = std::move(surface);
  for (Body& sheet : body.sheets)
  {
    place(sheet.surface, scale, offset);
  }
  return result;
}
} // namespace bodies

#include "Bodies/RandomBodies.h"

#include "Bodies/RandomParts.h"
#include "Remeshing/SurfaceRemeshing.h"
#include "Surface/Preparation.h"
#include "Triangles/FeatureSplit.h"

#include <CGAL/Polygon_mesh_processing/corefinement.h>

#include <cmath>

namespace bodies
{
namespace
{
using ransmesh::Vector3;
namespace Processing = CGAL::Polygon_mesh_processing;

Facets randomFacets(Dice& dice)
{
  const int kind = dice.upTo(3);
  const int corners = kind == 0 ? 4 : 3 + dice.upTo(6);
  if (kind == 2)
  {
    return ball(dice.between(0.2, 0.6), 9, 18);
  }
  const double height = dice.between(0.1, 0.8);
  const double a = dice.between(0.1, 0.6);
  const double b = corners == 4 ? dice.between(0.1, 0.6) : a;
  return prism(corners, a, b, height);
}

Solid randomPart(Dice& dice)
{
  Facets facets = randomFacets(dice);
  // Half of the parts stand parallel to each other: right angles and common planes are the hard cases.
  const Frame frame = dice.upTo(2) == 0 ? Frame{} : randomFrame(dice);
  const Vector3 place = dice.between(0, 0.5) * dice.direction();
  for (Vector3& p : facets.points)
  {
    p = frame(p) + place;
  }
  return solidOf(facets);
}

Solid randomSolid(Dice& dice)
{
  Solid solid = randomPart(dice);
  for (int parts = dice.upTo(3); parts > 0; --parts)
  {
    Solid other = randomPart(dice);
    Solid together;
    if (Processing::corefine_and_compute_union(solid, other, together))
    {
      solid = together;
    }
  }
  for (int cuts = dice.upTo(3); cuts > 0; --cuts)
  {
    cutByRandomPlane(dice, solid);
  }
  solid.collect_garbage();
  return solid;
}
} // namespace

RandomBody randomBody(std::uint32_t seed)
{
  Dice dice(seed);
  RandomBody result;
  result.body.patches = { { "fluid", ransmesh::PatchType::Patch },
    { "body_wall", ransmesh::PatchType::Wall } };
  result.size = dice.between(0.06, 0.2);
  result.scale = std::pow(10, dice.between(-3, 6));
  const Frame frame = randomFrame(dice);
  ransmesh::SurfaceMesh surface = toSurface(randomSolid(dice));
  ransmesh::RemeshingOptions options;
  options.length = result.size;
  ransmesh::RemeshingReport report;
  if (!remeshSurface(surface, options, report).ok() ||
    !prepareSurface(surface, result.body.patches, {}, {}).outcome.ok())
  {
    return result;
  }
  if (seed % 2 != 0)
  {
    splitByAngle(surface, result.body.patches, 1, 30);
  }
  for (Vector3& p : surface.points)
  {
    p = result.scale * frame(p);
  }
  result.size *= result.scale;
  result.body.surface = std::move(surface);
  return result;
}
} // namespace bodies

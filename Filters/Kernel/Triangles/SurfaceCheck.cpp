#include "Triangles/SurfaceCheck.h"

#include <cstdio>

namespace ransmesh
{
namespace
{
// Determinants of the fifth order in the coordinates must neither overflow nor vanish.
constexpr double LargestCoordinate = 1e50;
constexpr double SmallestExtent = 1e-50;

} // namespace

bool isUsable(const Vector3& p)
{
  return isFinite(p) &&
    std::fmax(std::fabs(p.x), std::fmax(std::fabs(p.y), std::fabs(p.z))) <= LargestCoordinate;
}

std::string placeOf(const Vector3& p)
{
  char text[96];
  std::snprintf(text, sizeof text, "(%.7g, %.7g, %.7g)", p.x, p.y, p.z);
  return text;
}

std::string placeOf(const SurfaceMesh& surface, Index triangle, const PatchTable& patches)
{
  return placeOf(centreOf(surface, triangle)) + " in patch '" + patches[surface.patch[triangle]].name + "'";
}

Outcome checkCoordinates(const SurfaceMesh& surface, const char* what)
{
  for (std::size_t i = 0; i < surface.points.size(); ++i)
  {
    const Vector3& p = surface.points[i];
    if (!isFinite(p))
    {
      return Outcome::badInput("point " + std::to_string(i) + " of the " + what +
        " is not finite: " + placeOf(p) + "; repair the file or the filter that made it");
    }
    if (!isUsable(p))
    {
      return Outcome::badInput("point " + std::to_string(i) + " of the " + what + " lies at " + placeOf(p) +
        ", too far away to compute with (limit 1e50); check the units");
    }
  }
  return Outcome::done();
}

Outcome checkExtent(const SurfaceMesh& surface)
{
  if (surface.triangles.empty())
  {
    return Outcome::badInput("the input is empty: connect a surface of triangles or polygons");
  }
  if (Outcome outcome = checkCoordinates(surface, "surface"); !outcome.ok())
  {
    return outcome;
  }
  const Extent extent = extentOf(surface.points);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (extent.length(axis) < SmallestExtent)
    {
      return Outcome::badInput(std::string("the surface has no extent along ") + "xyz"[axis] +
        ": all its points have the coordinate " + std::to_string(extent.low[axis]) +
        "; a closed surface that encloses a volume is needed");
    }
  }
  return Outcome::done();
}
} // namespace ransmesh

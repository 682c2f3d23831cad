#include "DomainPlane.h"

#include "Triangles/SurfaceRepair.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace ransmesh
{
namespace
{
constexpr double RidgeAngle = 30; // degrees: sharper edges keep their line where they are cut

std::string nameOf(const DomainPlane& plane)
{
  std::ostringstream text;
  text << plane.purpose << " "
       << "xyz"[plane.plane.axis] << " = " << plane.plane.place;
  return text.str();
}

void chooseSide(const Extent& extent, DomainPlane& plane)
{
  const int axis = plane.plane.axis;
  const double above = extent.high[axis] - plane.plane.place;
  const double below = plane.plane.place - extent.low[axis];
  const bool isAbove = above >= below * (1 - PlaneTolerance);
  plane.plane.keepsAbove =
    plane.keep == DomainPlane::Keep::Larger ? isAbove : plane.keep == DomainPlane::Keep::Above;
}

// The only patch that lies in the plane as a whole.
int patchIn(const SurfaceMesh& surface, const AxisPlane& plane, double tolerance)
{
  std::map<int, bool> liesIn;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto& v = surface.triangles[t];
    const bool isIn = std::all_of(v.begin(), v.end(),
      [&](Index corner) { return std::fabs(surface.points[corner][plane.axis] - plane.place) <= tolerance; });
    const auto known = liesIn.try_emplace(surface.patch[t], true).first;
    known->second = known->second && isIn;
  }
  int found = None;
  for (const auto& [patch, isIn] : liesIn)
  {
    if (isIn && found != None)
    {
      return None;
    }
    found = isIn ? patch : found;
  }
  return found;
}

Outcome checkAxes(const std::vector<DomainPlane>& planes)
{
  for (std::size_t i = 0; i < planes.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      if (planes[i].plane.axis == planes[j].plane.axis)
      {
        return Outcome::badInput("the " + nameOf(planes[j]) + " and the " + nameOf(planes[i]) +
          " lie across one axis: give one of them");
      }
    }
  }
  return Outcome::done();
}
} // namespace

Outcome cutByPlanes(SurfaceMesh& surface, std::vector<DomainPlane>& planes)
{
  if (Outcome outcome = checkAxes(planes); !outcome.ok())
  {
    return outcome;
  }
  mergeEqualPoints(surface);
  const double tolerance = PlaneTolerance * extentOf(surface.points).largestLength();
  for (DomainPlane& plane : planes)
  {
    chooseSide(extentOf(surface.points), plane);
    plane.ownPatch = patchIn(surface, plane.plane, tolerance);
    cutByPlane(surface, plane.plane, tolerance, RidgeAngle);
    if (surface.triangles.empty())
    {
      return Outcome::badInput("nothing of the surface lies " +
        std::string(plane.plane.keepsAbove ? "above" : "below") + " the " + nameOf(plane) +
        ": move the plane, or turn the surface");
    }
    mergeEqualPoints(surface);
  }
  return Outcome::done();
}

Outcome checkReach(const SurfaceMesh& surface, const std::vector<DomainPlane>& planes)
{
  for (const DomainPlane& plane : planes)
  {
    const auto isIn = [&plane](const Vector3& p) { return plane.plane.holds(p); };
    if (std::none_of(surface.points.begin(), surface.points.end(), isIn))
    {
      return Outcome::badInput("the surface does not reach the " + nameOf(plane) +
        ", so that the plane does not bound what it encloses: move the plane, or add a far field");
    }
  }
  return Outcome::done();
}

void snapToPlanes(SurfaceMesh& surface, const std::vector<DomainPlane>& planes)
{
  const double tolerance = PlaneTolerance * extentOf(surface.points).largestLength();
  for (Vector3& p : surface.points)
  {
    for (const DomainPlane& plane : planes)
    {
      double& x = p[plane.plane.axis];
      x = std::fabs(x - plane.plane.place) <= tolerance ? plane.plane.place : x;
    }
  }
}

std::vector<AxisPlane> axisPlanes(const std::vector<DomainPlane>& planes)
{
  std::vector<AxisPlane> plain;
  plain.reserve(planes.size());
  for (const DomainPlane& plane : planes)
  {
    plain.push_back(plane.plane);
  }
  return plain;
}
} // namespace ransmesh

#include "DomainRequest.h"

#include "BoxFacets.h"
#include "PlaneFacet.h"
#include "PlaneSeams.h"
#include "Worker/RequestParts.h"

#include "Domain/SurfaceSizes.h"

namespace ransmesh
{
Outcome describeDomain(const Domain& domain, worker::Request& request)
{
  const SurfaceMesh& surface = domain.surface;
  for (const Vector3& p : surface.points)
  {
    addPoint(request, p);
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto& v = surface.triangles[t];
    addPolygon(request, { v[0], v[1], v[2] }, surface.patch[t]);
  }
  if (domain.box)
  {
    return addBox(domain, request);
  }
  const std::vector<PlaneSeam> seams = addSeams(domain, request);
  for (std::size_t i = 0; i < seams.size(); ++i)
  {
    PlaneEdges edges = edgesIn(surface, domain.isSheet, domain.planes[i].plane);
    edges.borders.insert(edges.borders.end(), seams[i].begin(), seams[i].end());
    PlaneArea area;
    const Outcome outcome = addPlaneFacet(domain.planes[i], edges, std::nullopt, request, area);
    if (!outcome.ok())
    {
      return outcome;
    }
  }
  return Outcome::done();
}

void describeSizes(const SurfaceMesh& surface, const SizeLimits& limits, worker::Request& request)
{
  request.maximumSize = limits.maximum;
  request.slope = limits.slope;
  const std::vector<double> sizes = sizesOnSurface(surface, limits.slope);
  for (std::size_t v = 0; v < sizes.size(); ++v)
  {
    const Vector3& p = surface.points[v];
    request.pointSources.insert(request.pointSources.end(), { p.x, p.y, p.z, sizes[v] });
  }
  for (const SizeBox& b : limits.boxes)
  {
    request.boxSources.insert(
      request.boxSources.end(), { b.low.x, b.high.x, b.low.y, b.high.y, b.low.z, b.high.z, b.size });
  }
  for (const SizeSphere& s : limits.spheres)
  {
    request.sphereSources.insert(
      request.sphereSources.end(), { s.centre.x, s.centre.y, s.centre.z, s.radius, s.size });
  }
  for (const SizeLine& l : limits.lines)
  {
    request.lineSources.insert(
      request.lineSources.end(), { l.from.x, l.from.y, l.from.z, l.to.x, l.to.y, l.to.z, l.radius, l.size });
  }
}
} // namespace ransmesh

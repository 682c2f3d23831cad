#include "DomainRefinement.h"

#include "Boundary/SheetAttachment.h"
#include "Boundary/SurfaceSizes.h"
#include "Geometry/TetrahedronMeasures.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace ransmesh
{
namespace
{
// A flag a point: whether it lies on a patch of type interface, which must not change.
std::vector<char> frozenPoints(const Domain& domain)
{
  std::vector<char> isFrozen(domain.surface.points.size(), 0);
  for (std::size_t t = 0; t < domain.surface.triangles.size(); ++t)
  {
    if (domain.patches[domain.surface.patch[t]].type == PatchType::Interface)
    {
      for (const Index v : domain.surface.triangles[t])
      {
        isFrozen[v] = 1;
      }
    }
  }
  return isFrozen;
}

// Of the space between the bodies and the box, or, without a box, inside the surface.
double domainVolume(const Domain& domain)
{
  // The planes' own parts enclose nothing with a point in them.
  Vector3 apex = domain.surface.points[0];
  for (const ClosingPlane& plane : domain.planes)
  {
    apex[plane.plane.axis] = plane.plane.place;
  }
  const double inside = enclosedVolume(withoutSheets(domain.surface, domain.isSheet), apex);
  if (!domain.box)
  {
    return inside;
  }
  const Vector3 sides = domain.box->corners[7] - domain.box->corners[0];
  return sides.x * sides.y * sides.z - inside;
}

std::string sentenceOf(const FlatTriangleReport& report)
{
  std::ostringstream text;
  text << "Mended: " << report.swaps << (report.swaps == 1 ? " diagonal" : " diagonals")
       << " of surface triangles swapped and " << report.splits << (report.splits == 1 ? " edge" : " edges")
       << " split, no point moved, no new edge is farther than " << report.largestShift
       << " from that which it replaced; largest angle " << report.largestBefore << " degrees before, "
       << report.largestAfter << " after; triangles above " << FlatTriangleAngle
       << " degrees: " << report.flatBefore << " before, " << report.flatAfter
       << " after (ImproveSurfaceTriangles off keeps all triangles).";
  return text.str();
}

FlatTriangleReport improveTriangles(const MesherSettings& settings, Domain& domain, MesherReport& report)
{
  if (!settings.improveTriangles)
  {
    return {};
  }
  const FlatTriangleReport improved =
    mendFlatTriangles(domain.surface, settings.surfaceAngle, frozenPoints(domain));
  if (improved.isRefused)
  {
    report.remark("No diagonals of surface triangles were swapped, since the surface would cut itself then; "
                  "try a smaller MaximumSurfaceAngle.");
  }
  if (improved.swaps + improved.splits > 0)
  {
    report.remark(sentenceOf(improved));
  }
  return improved;
}

Outcome divideLongEdges(const SizeLimits& limits, Domain& domain)
{
  const double wanted = limits.maximum;
  const double tets = wanted > 0 ? 8.5 * domainVolume(domain) / (wanted * wanted * wanted) : 0;
  constexpr double mostTets = 4e8;
  if (tets > mostTets ||
    !halveLongEdges(domain.surface, [&limits](const Vector3& x) { return limits.at(x); }))
  {
    return Outcome::badInput("the sizes that are asked for make too large a mesh (more than 400 million "
                             "tetrahedra, or 20 million surface triangles); ask for larger edges");
  }
  return Outcome::done();
}

Outcome mesh(const MesherSettings& settings, const Domain& domain, const TetGenWorker& worker,
  const Context& context, DomainMesh& result, MesherReport& report)
{
  MeshingResult meshed;
  Outcome outcome = meshDomain(domain, settings.meshing, worker, context, meshed);
  for (const std::string& remark : meshed.remarks)
  {
    report.remark(remark);
  }
  result.mesh = std::move(meshed.mesh);
  result.switches = std::move(meshed.switches);
  report.problemSurface = std::move(meshed.problemSurface);
  report.problems = std::move(meshed.problems);
  return outcome;
}

// Below it double precision does not tell which way a tetrahedron is turned.
constexpr double FlatQuality = 1e-13;

// Whether double precision does not tell of some tetrahedra which way they are turned: programs that compute in it
// would take them for inverted.
bool hasFlatTetrahedra(const MeshData& mesh)
{
  const auto& p = mesh.points;
  return std::any_of(mesh.tetrahedra.begin(), mesh.tetrahedra.end(),
    [&p](const auto& t) { return quality(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) < FlatQuality; });
}

Outcome meshAsGiven(const MesherSettings& settings, const Domain& domain, const TetGenWorker& worker,
  const Context& context, DomainMesh& result, MesherReport& report)
{
  result.triangles = {};
  Domain asGiven = domain;
  if (Outcome divided = divideLongEdges(settings.meshing.limits, asGiven); !divided.ok())
  {
    return divided;
  }
  return mesh(settings, asGiven, worker, context, result, report);
}
} // namespace

Outcome refineAndMesh(const MesherSettings& settings, const Domain& domain, const TetGenWorker& worker,
  const Context& context, DomainMesh& result, MesherReport& report)
{
  Domain improved = domain;
  result.triangles = improveTriangles(settings, improved, report);
  if (Outcome outcome = divideLongEdges(settings.meshing.limits, improved); !outcome.ok())
  {
    return outcome;
  }
  const bool isChanged = result.triangles.swaps + result.triangles.splits > 0;
  const Outcome outcome = mesh(settings, improved, worker, context, result, report);
  if (outcome.kind == Outcome::Kind::Cancelled || !isChanged)
  {
    return outcome;
  }
  if (!outcome.ok())
  {
    report.remark("TetGen does not mesh the mended surface triangles: they are kept as they were given.");
    return meshAsGiven(settings, domain, worker, context, result, report);
  }
  if (!hasFlatTetrahedra(result.mesh))
  {
    return outcome;
  }
  DomainMesh unmended;
  MesherReport silent{ [](const std::string&) {}, {}, {} };
  const Outcome second = meshAsGiven(settings, domain, worker, context, unmended, silent);
  if (second.kind == Outcome::Kind::Cancelled)
  {
    return second;
  }
  if (second.ok() && !hasFlatTetrahedra(unmended.mesh))
  {
    report.remark(
      "The mended surface triangles led to tetrahedra without thickness: they are kept as they were given.");
    result = std::move(unmended);
  }
  return outcome;
}
} // namespace ransmesh

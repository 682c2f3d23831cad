#include "DomainRefinement.h"

#include "Domain/SheetAttachment.h"
#include "Domain/SurfaceSizes.h"
#include "Improvement/FlatTetrahedra.h"

#include <algorithm>
#include <optional>
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

// How the triangles are bettered, from most to least.
enum class Mending
{
  SwapsAndSplits,
  Swaps,
  None
};

FlatTriangleReport improveTriangles(
  const MesherSettings& settings, Mending mending, Domain& domain, std::vector<std::string>& remarks)
{
  if (mending == Mending::None)
  {
    return {};
  }
  const FlatTriangleReport improved = mendFlatTriangles(
    domain.surface, settings.surfaceAngle, frozenPoints(domain), mending == Mending::SwapsAndSplits);
  if (improved.isRefused)
  {
    remarks.emplace_back(
      "No diagonals of surface triangles were swapped, since the surface would cut itself then; "
      "try a smaller MaximumSurfaceAngle.");
  }
  if (improved.swaps + improved.splits > 0)
  {
    remarks.push_back(sentenceOf(improved));
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

// Tetrahedra without thickness are swapped away; how many are left. Sheets would have to be cut open for it.
std::size_t flatTetrahedraLeft(const Domain& domain, MeshData& mesh)
{
  const std::size_t count = countFlatTetrahedra(mesh);
  const bool hasSheets = std::find(domain.isSheet.begin(), domain.isSheet.end(), 1) != domain.isSheet.end();
  return count == 0 || hasSheets ? count : swapFlatTetrahedra(domain.patches, mesh);
}

// One way of bettering the triangles, and the mesh that came of it.
struct Trial
{
  Outcome outcome;
  FlatTriangleReport triangles;
  MeshingResult meshed;
  std::vector<std::string> remarks;
  bool hasFlats = false; // tetrahedra without thickness
};

bool mayTryAgain(const Trial& trial)
{
  return trial.hasFlats || (!trial.outcome.ok() && trial.outcome.kind != Outcome::Kind::Cancelled);
}

Trial tryMending(const MesherSettings& settings, Mending mending, Domain domain, const TetGenWorker& worker,
  const Context& context)
{
  Trial trial;
  trial.triangles = improveTriangles(settings, mending, domain, trial.remarks);
  trial.outcome = divideLongEdges(settings.meshing.limits, domain);
  if (trial.outcome.ok())
  {
    trial.outcome = meshDomain(domain, settings.meshing, worker, context, trial.meshed);
  }
  trial.hasFlats = trial.outcome.ok() && flatTetrahedraLeft(domain, trial.meshed.mesh) > 0;
  return trial;
}

// The next trial, after one that was not good; none where nothing would be different.
std::optional<Mending> lessThan(Mending mending, const FlatTriangleReport& triangles)
{
  if (mending == Mending::None || triangles.swaps + triangles.splits == 0)
  {
    return {};
  }
  return mending == Mending::SwapsAndSplits && triangles.splits > 0 ? Mending::Swaps : Mending::None;
}

std::string sentenceAfter(const Trial& failed, Mending next)
{
  return std::string(failed.outcome.ok()
             ? "With the surface triangles mended so, tetrahedra have no thickness"
             : "TetGen does not mesh the surface triangles mended so") +
    (next == Mending::Swaps ? ": no edges are split." : ": they are kept as they were given.");
}

void give(Trial& trial, DomainMesh& result, MesherReport& report)
{
  trial.remarks.insert(trial.remarks.end(), trial.meshed.remarks.begin(), trial.meshed.remarks.end());
  for (const std::string& remark : trial.remarks)
  {
    report.remark(remark);
  }
  result.triangles = trial.triangles;
  result.mesh = std::move(trial.meshed.mesh);
  result.switches = std::move(trial.meshed.switches);
  report.problemSurface = std::move(trial.meshed.problemSurface);
  report.problems = std::move(trial.meshed.problems);
}
} // namespace

Outcome refineAndMesh(const MesherSettings& settings, const Domain& domain, const TetGenWorker& worker,
  const Context& context, DomainMesh& result, MesherReport& report)
{
  Mending mending = settings.improveTriangles ? Mending::SwapsAndSplits : Mending::None;
  Trial trial = tryMending(settings, mending, domain, worker, context);
  std::optional<Trial> withFlats; // better than nothing
  MesherSettings now = settings;
  for (auto next = lessThan(mending, trial.triangles); next && mayTryAgain(trial);
       next = lessThan(mending, trial.triangles))
  {
    std::vector<std::string> remarks = trial.remarks;
    remarks.push_back(sentenceAfter(trial, *next));
    now.meshing.refine = now.meshing.refine && !trial.meshed.isEndless; // with less mending neither
    if (trial.outcome.ok() && !withFlats)
    {
      withFlats = std::move(trial);
    }
    mending = *next;
    trial = tryMending(now, mending, domain, worker, context);
    trial.remarks.insert(trial.remarks.begin(), remarks.begin(), remarks.end());
  }
  Trial& given = withFlats && mayTryAgain(trial) ? *withFlats : trial;
  give(given, result, report);
  return given.outcome;
}
} // namespace ransmesh

#include "Surface/Preparation.h"

#include "Surface/DiagnosisText.h"
#include "Surface/Remedy.h"
#include "Triangles/SurfaceRepair.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
SurfaceVerdict refusal(const SurfaceMesh& surface, const PatchTable& patches, const Diagnosis& diagnosis,
  const std::vector<AxisPlane>& closedBy)
{
  SurfaceVerdict verdict;
  for (const Fault& fault : diagnosis.faults)
  {
    verdict.findings.insert(verdict.findings.end(), fault.findings.begin(), fault.findings.end());
  }
  verdict.outcome = Outcome::badInput(describe(diagnosis, surface, patches) +
    ". Remedy: " + proposeRemedy(surface, patches, diagnosis, closedBy));
  return verdict;
}

std::vector<std::string> textsOf(const std::vector<Repair>& repairs)
{
  std::vector<std::string> texts;
  texts.reserve(repairs.size());
  for (const Repair& repair : repairs)
  {
    texts.push_back(repair.text);
  }
  return texts;
}

// What can be said before coordinates are computed with.
SurfaceVerdict checkInput(const SurfaceMesh& surface, const PatchTable& patches)
{
  SurfaceVerdict verdict;
  DiagnosisOptions topology;
  topology.intersections = false;
  const auto& points = surface.points;
  if (!std::all_of(points.begin(), points.end(), isUsable))
  {
    const Diagnosis diagnosis = diagnose(surface, topology, {});
    if (diagnosis.find(SurfaceFault::NotFinite))
    {
      return refusal(surface, patches, diagnosis, {});
    }
  }
  verdict.outcome = checkExtent(surface);
  return verdict;
}
} // namespace

SurfaceVerdict prepareSurface(
  SurfaceMesh& surface, PatchTable& patches, const PreparationOptions& options, const Context& context)
{
  SurfaceVerdict verdict = checkInput(surface, patches);
  if (!verdict.outcome.ok())
  {
    return verdict;
  }
  SurfaceMesh mended = surface;
  PatchTable mendedPatches = patches;
  std::vector<Repair> repairs;
  if (options.repair)
  {
    RepairOptions how = options.repairs;
    how.closedBy = options.closedBy;
    repairs = repairSurface(mended, mendedPatches, how);
  }
  else
  {
    mergeEqualPoints(mended);
  }
  if (mended.triangles.empty())
  {
    verdict.outcome = Outcome::badInput("all triangles of the surface are degenerate");
    return verdict;
  }
  DiagnosisOptions examination = options.diagnosis;
  examination.closedBy = options.closedBy;
  const Diagnosis after = diagnose(mended, examination, context);
  if (!after.isSound())
  {
    const Diagnosis given = repairs.empty() ? after : diagnose(surface, examination, context);
    const bool isInGiven = !given.isSound();
    verdict = isInGiven ? refusal(surface, patches, given, options.closedBy)
                        : refusal(mended, mendedPatches, after, options.closedBy);
    surface = isInGiven ? surface : mended;
    patches = isInGiven ? patches : mendedPatches;
    return verdict;
  }
  if (const Fault* near = after.find(SurfaceFault::NearSheets))
  {
    Diagnosis only;
    only.faults = { *near };
    context.remark(describe(only, mended, mendedPatches));
  }
  surface = std::move(mended);
  patches = std::move(mendedPatches);
  verdict.repairs = textsOf(repairs);
  return verdict;
}
} // namespace ransmesh

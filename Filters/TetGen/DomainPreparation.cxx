#include "DomainPreparation.h"

#include "PatchNaming.h"

#include "Boundary/FeatureSplit.h"
#include "Boundary/SheetAttachment.h"
#include "Boundary/SurfaceRemeshing.h"

#include <sstream>

namespace ransmesh
{
namespace
{
// The types that the user did not set and that names do not tell: with a box around them, bodies are walls.
void makeBodiesWalls(PatchTable& patches)
{
  for (std::size_t i = 1; i < patches.size(); ++i)
  {
    if (patches[i].type == PatchType::Patch)
    {
      patches[i].type = PatchType::Wall;
    }
  }
}

// Passes on what a check of the surface said.
Outcome accept(const SurfaceVerdict& verdict, const SurfaceMesh& surface, MesherReport& report)
{
  for (const std::string& repair : verdict.repairs)
  {
    report.remark("Mended: " + repair + ".");
  }
  if (!verdict.outcome.ok())
  {
    report.problemSurface = surface;
    report.problems = verdict.findings;
  }
  return verdict.outcome;
}

Outcome checkSurface(SurfaceInput& input, MesherReport& report)
{
  const SurfaceVerdict verdict = mendAndCheck(input.surface, input.patches);
  return accept(verdict, input.surface, report);
}

void splitPatches(const MesherSettings& settings, SurfaceInput& input)
{
  if (settings.patchFromFeatureAngle)
  {
    for (const int patch : input.wholePieces)
    {
      splitByAngle(input.surface, input.patches, patch, settings.featureAngle);
    }
  }
}

Outcome remesh(const MesherSettings& settings, SurfaceInput& input, MesherReport& report)
{
  if (settings.surfaceEdgeLength == 0)
  {
    return Outcome::done();
  }
  Outcome outcome = remeshSurface(input.surface, settings.surfaceEdgeLength, settings.featureAngle);
  if (!outcome.ok())
  {
    return outcome;
  }
  outcome = checkSurface(input, report);
  if (!outcome.ok())
  {
    std::ostringstream text;
    text << outcome.message << ". Remeshing to edges of " << settings.surfaceEdgeLength
         << " spoiled the surface: details of it are smaller. Choose a smaller SurfaceEdgeLength";
    outcome.message = text.str();
  }
  return outcome;
}

Outcome setPatchTypes(const MesherSettings& settings, SurfaceInput& input)
{
  input.isSheet.resize(input.patches.size(), 0);
  const Outcome outcome = setTypes(settings.typeOfPattern, input.patches);
  return outcome.ok() ? checkSheetTypes(input.patches, input.isSheet) : outcome;
}

std::optional<Extent> extentOfBox(const Domain& domain)
{
  return domain.box ? std::optional(Extent{ domain.box->corners[0], domain.box->corners[7] }) : std::nullopt;
}

Outcome addSheets(SurfaceMesh sheets, Domain& domain, MesherReport& report)
{
  if (sheets.triangles.empty())
  {
    return Outcome::done();
  }
  const SurfaceVerdict verdict =
    attachSheets(domain.surface, std::move(sheets), domain.patches, extentOfBox(domain));
  return accept(verdict, domain.surface, report);
}
} // namespace

Outcome prepareDomain(
  const MesherSettings& settings, SurfaceInput input, Domain& domain, MesherReport& report)
{
  if (Outcome outcome = checkSurface(input, report); !outcome.ok())
  {
    return outcome;
  }
  splitPatches(settings, input);
  if (Outcome outcome = remesh(settings, input, report); !outcome.ok())
  {
    return outcome;
  }
  if (settings.farFieldMargins)
  {
    makeBodiesWalls(input.patches);
    domain.box = makeFarField(extentOf(input.surface.points), *settings.farFieldMargins, input.patches);
  }
  if (Outcome outcome = setPatchTypes(settings, input); !outcome.ok())
  {
    return outcome;
  }
  domain.surface = std::move(input.surface);
  domain.patches = std::move(input.patches);
  domain.isSheet = std::move(input.isSheet);
  return addSheets(std::move(input.sheets), domain, report);
}
} // namespace ransmesh

#include "DomainPreparation.h"

#include "PatchNaming.h"

#include "Domain/SheetAttachment.h"
#include "Surface/Preparation.h"
#include "Triangles/FeatureSplit.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
// The types that the user did not set and that names do not tell: with a box around them, bodies are walls.
void makeBodiesWalls(const std::vector<char>& isSheet, PatchTable& patches)
{
  for (std::size_t i = 1; i < patches.size(); ++i)
  {
    if (patches[i].type == PatchType::Patch && !isSheet[i])
    {
      patches[i].type = PatchType::Wall;
    }
  }
}

void append(const SurfaceMesh& part, SurfaceMesh& surface)
{
  const auto offset = static_cast<Index>(surface.points.size());
  surface.points.insert(surface.points.end(), part.points.begin(), part.points.end());
  surface.patch.insert(surface.patch.end(), part.patch.begin(), part.patch.end());
  for (const auto& t : part.triangles)
  {
    surface.triangles.push_back({ t[0] + offset, t[1] + offset, t[2] + offset });
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

Outcome attach(const SurfaceMesh& sheets, const std::optional<Extent>& box, const PatchTable& patches,
  SurfaceMesh& surface, MesherReport& report)
{
  if (sheets.triangles.empty())
  {
    return Outcome::done();
  }
  const SurfaceVerdict verdict = attachSheets(surface, sheets, patches, box);
  return accept(verdict, surface, report);
}

using Planes = std::vector<DomainPlane>;

Outcome cutSurface(Planes& planes, SurfaceInput& input)
{
  if (planes.empty())
  {
    return Outcome::done();
  }
  const Outcome outcome = checkExtent(input.surface);
  return outcome.ok() ? cutByPlanes(input.surface, planes) : outcome;
}

Outcome checkSurface(
  const MesherSettings& settings, const Planes& planes, SurfaceInput& input, MesherReport& report)
{
  Context context;
  context.log = [&report](const std::string& text) { report.remark("Near each other: " + text + "."); };
  PreparationOptions options = settings.preparation;
  options.closedBy = axisPlanes(planes);
  const SurfaceVerdict verdict = prepareSurface(input.surface, input.patches, options, context);
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

// Surfaces and sheets hang together while they are remeshed, so that they share their points afterwards.
Outcome remeshTogether(
  const RemeshingOptions& options, SurfaceInput& input, SurfaceMesh& whole, RemeshingReport& made)
{
  if (Outcome outcome = remeshSurface(whole, options, made); !outcome.ok())
  {
    return outcome;
  }
  std::vector<char> isClosed = input.isSheet;
  for (char& flag : isClosed)
  {
    flag = flag == 0;
  }
  input.surface = withoutSheets(whole, input.isSheet);
  input.sheets = withoutSheets(whole, isClosed);
  return Outcome::done();
}

Outcome remesh(
  const MesherSettings& settings, const Planes& planes, SurfaceInput& input, MesherReport& report)
{
  if (!settings.sizing.isWanted())
  {
    return Outcome::done();
  }
  SurfaceMesh whole = input.surface;
  input.isSheet.resize(input.patches.size(), 0);
  if (Outcome outcome = attach(input.sheets, std::nullopt, input.patches, whole, report); !outcome.ok())
  {
    return outcome;
  }
  RemeshingOptions options;
  RemeshingReport made;
  PatchTable typed = input.patches;
  setTypes(settings.typeOfPattern, typed); // patches of type interface are kept
  if (Outcome outcome = remeshingOptions(settings.sizing, typed, whole, options); !outcome.ok())
  {
    return outcome;
  }
  options.limit = [&settings](const Vector3& x) { return settings.meshing.limits.at(x); };
  options.gapSide = input.sheets.triangles.empty() ? options.gapSide : GapSide::Both;
  if (Outcome outcome = remeshTogether(options, input, whole, made); !outcome.ok())
  {
    return outcome;
  }
  snapToPlanes(input.sheets, planes);
  snapToPlanes(input.surface, planes);
  Outcome outcome = checkSurface(settings, planes, input, report);
  if (!outcome.ok())
  {
    outcome.message += ". Remeshing spoiled the surface: details of it are smaller than the new edges. "
                       "Choose a smaller SurfaceEdgeLength";
    return outcome;
  }
  report.remark(textOf(made));
  return outcome;
}

Outcome setPatchTypes(const MesherSettings& settings, SurfaceInput& input)
{
  input.isSheet.resize(input.patches.size(), 0);
  const Outcome outcome = setTypes(settings.typeOfPattern, input.patches);
  return outcome.ok() ? checkSheetTypes(input.patches, input.isSheet) : outcome;
}

// Surfaces whose insides are kept have the mesh on both sides, as sheets have.
Outcome keepInsides(const MesherSettings& settings, SurfaceInput& input)
{
  return flagPatches(settings.keptInsides, "KeepInside", input.patches, input.isSheet);
}

// The patches at which the far field lies: all sides of the box but the planes.
std::vector<int> farPatches(const FarFieldBox& box, const Planes& planes)
{
  std::vector<int> patches;
  for (int side = 0; side < 6; ++side)
  {
    const auto isSide = [side](const DomainPlane& plane) { return sideOf(plane.plane) == side; };
    if (std::none_of(planes.begin(), planes.end(), isSide))
    {
      patches.push_back(box.patches[side]);
    }
  }
  return patches;
}

// A box, or a sphere as a part of the surface.
void addFarField(const MesherSettings& settings, const Planes& planes, SurfaceInput& input, Domain& domain)
{
  const FarFieldOptions& options = *settings.farField;
  const Extent bodies = extentOf(input.surface.points);
  makeBodiesWalls(input.isSheet, input.patches);
  if (options.isSphere)
  {
    const SurfaceMesh sphere =
      makeSphere(bodies, options.margins[0], settings.meshing.limits.maximum, planes, input.patches);
    domain.farField = { sphere.patch.front() };
    append(sphere, input.surface);
    return;
  }
  domain.box = makeFarField(bodies, options, planes, input.patches);
  domain.farField = farPatches(*domain.box, planes);
}

// The plane's own patch becomes what the plane is.
int takeOver(const DomainPlane& plane, PatchTable& patches)
{
  Patch& own = patches[plane.ownPatch];
  own.type = own.type == PatchType::Patch ? plane.patch.type : own.type;
  return plane.ownPatch;
}

// The planes' patches: sides of the box, or what lay in the plane, or new ones.
void addPlanes(const Planes& planes, SurfaceInput& input, Domain& domain)
{
  for (const DomainPlane& plane : planes)
  {
    const int patch = domain.box ? domain.box->patches[sideOf(plane.plane)]
      : plane.ownPatch != None   ? takeOver(plane, input.patches)
                                 : addPatch(plane.patch, input.patches);
    domain.planes.push_back({ plane.plane, patch });
  }
}

std::optional<Extent> extentOfBox(const Domain& domain)
{
  return domain.box ? std::optional(Extent{ domain.box->corners[0], domain.box->corners[7] }) : std::nullopt;
}

} // namespace

Outcome prepareDomain(
  const MesherSettings& settings, SurfaceInput input, Domain& domain, MesherReport& report)
{
  Planes planes = settings.planes;
  if (Outcome outcome = cutSurface(planes, input); !outcome.ok())
  {
    return outcome;
  }
  if (Outcome outcome = checkSurface(settings, planes, input, report); !outcome.ok())
  {
    return outcome;
  }
  splitPatches(settings, input);
  if (Outcome outcome = remesh(settings, planes, input, report); !outcome.ok())
  {
    return outcome;
  }
  if (Outcome outcome = keepInsides(settings, input); !outcome.ok())
  {
    return outcome;
  }
  if (settings.farField)
  {
    if (Outcome outcome = checkSides(*settings.farField); !outcome.ok())
    {
      return outcome;
    }
    addFarField(settings, planes, input, domain);
  }
  if (Outcome outcome = domain.box ? Outcome::done() : checkReach(input.surface, planes); !outcome.ok())
  {
    return outcome;
  }
  addPlanes(planes, input, domain);
  if (Outcome outcome = setPatchTypes(settings, input); !outcome.ok())
  {
    return outcome;
  }
  domain.surface = std::move(input.surface);
  domain.patches = std::move(input.patches);
  domain.isSheet = std::move(input.isSheet);
  return attach(input.sheets, extentOfBox(domain), domain.patches, domain.surface, report);
}
} // namespace ransmesh

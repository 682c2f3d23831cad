#include "DomainMeshing.h"

#include "DomainRequest.h"
#include "TetGenResult.h"

#include "Domain/SheetAttachment.h"
#include "Mesh/Validation.h"
#include "Surface/DiagnosisText.h"
#include "Triangles/SurfaceEdges.h"

#include <algorithm>
#include <cstdio>
#include <set>

namespace ransmesh
{
namespace
{
// The attempts, from the usual to the tolerant. -Y keeps the surface's triangles; without it TetGen splits
// wall triangles, and does not end on some good bodies (measured). -T: the tolerance of coplanarity; without it 1e-8,
// and one sound body needs less, another more. -D1: no points are inserted; the last resort where refining does
// not end.
struct Variant
{
  const char* switches;
  bool refines;
};
constexpr Variant Variants[] = { { "Y", true }, { "YT1e-12", true }, { "YT1e-6", true },
  { "YT1e-12D1", false } };

// What the user is told where every attempt failed: that, and which parts of the surface come so near to each other
// that TetGen may not tell them apart.
constexpr double NearForTetGen = 1e-4; // of the largest extent

Context within(const Context& context, double from, double to)
{
  Context part = context;
  part.progress = [&context, from, to](double fraction, const char* phase)
  { context.report(from + fraction * (to - from), phase); };
  return part;
}

// One closed piece without branching edges has one inside: nothing is to be found out then.
bool mayHaveHoles(const SurfaceMesh& surface)
{
  std::vector<Index> piece(surface.triangles.size());
  for (std::size_t t = 0; t < piece.size(); ++t)
  {
    piece[t] = static_cast<Index>(t);
  }
  const auto root = [&piece](Index t)
  {
    while (piece[t] != t)
    {
      t = piece[t] = piece[piece[t]];
    }
    return t;
  };
  std::size_t pieces = surface.triangles.size();
  bool branching = false;
  forEachEdge(sortedEdges(surface),
    [&](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      branching = branching || last - first != 2;
      const Index a = root(first->triangle);
      const Index b = root((last - 1)->triangle);
      pieces -= a != b;
      piece[a] = b;
    });
  return branching || pieces > 1;
}

void remarkUnmeshed(const MeshData& mesh, const Domain& domain, std::vector<std::string>& remarks)
{
  const std::set<int> meshed(mesh.trianglePatch.begin(), mesh.trianglePatch.end());
  for (const int patch : std::set<int>(domain.surface.patch.begin(), domain.surface.patch.end()))
  {
    if (!meshed.contains(patch))
    {
      const std::string& name = domain.patches[patch].name;
      remarks.push_back(domain.isSheet[patch]
          ? "the sheet '" + name + "' does not lie in the fluid: left out"
          : "patch '" + name + "' lies inside a body and bounds no fluid: left out");
    }
  }
}

// TetGen rounds the points that it adds in a plane.
void putOnPlanes(const std::vector<ClosingPlane>& planes, MeshData& mesh)
{
  for (const ClosingPlane& plane : planes)
  {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      for (int i = 0; i < 3 && mesh.trianglePatch[t] == plane.patch; ++i)
      {
        mesh.points[mesh.triangles[t][i]][plane.plane.axis] = plane.plane.place;
      }
    }
  }
}

class Attempt
{
public:
  Attempt(const Domain& domain, const MeshingOptions& options, const TetGenWorker& worker)
    : domain_(domain)
    , closed_{ withoutSheets(domain.surface, domain.isSheet), domain.patches, domain.isSheet, domain.box,
      domain.planes, domain.farField }
    , options_(options)
    , worker_(worker)
  {
  }

  TetGenEnd run(const Variant& variant, const Context& context, MeshingResult& result) const
  {
    worker::Request request;
    if (Outcome outcome = describeDomain(domain_, request); !outcome.ok())
    {
      return { outcome };
    }
    double begin = 0;
    if (domain_.box || mayHaveHoles(closed_.surface))
    {
      begin = 0.2;
      // Sheets may divide the fluid: what is a body shows without them.
      worker::Request bodies;
      if (Outcome outcome = describeDomain(closed_, bodies); !outcome.ok())
      {
        return { outcome };
      }
      bodies.switches = std::string("pA") + variant.switches;
      worker::Result regions;
      TetGenEnd end = worker_.run(bodies, within(context, 0, begin), regions);
      if (!end.outcome.ok())
      {
        return end;
      }
      for (const Vector3& hole : findHoles(regions, domain_.farField))
      {
        request.holes.insert(request.holes.end(), { hole.x, hole.y, hole.z });
      }
    }
    request.switches = qualitySwitches(variant);
    describeSizes(domain_.surface, options_.limits, request);
    worker::Result raw;
    TetGenEnd end = worker_.run(request, within(context, begin, 0.9), raw);
    if (!end.outcome.ok())
    {
      return end;
    }
    result.switches = request.switches;
    return { accept(raw, context, result) };
  }

private:
  std::string qualitySwitches(const Variant& variant) const
  {
    char text[80];
    std::snprintf(text, sizeof text, "pq%.4g/%.4g%s", options_.radiusEdgeRatio, options_.minimumDihedral,
      variant.switches);
    return text;
  }

  Outcome accept(const worker::Result& raw, const Context& context, MeshingResult& result) const
  {
    context.report(0.9, "checking the mesh");
    AssembledMesh assembled = assemble(raw, domain_.isSheet);
    if (assembled.mesh.tetrahedra.empty())
    {
      return Outcome::badInput("the surface encloses no volume");
    }
    if (!assembled.unexpected.triangles.empty())
    {
      return refuseInside(assembled.unexpected, result);
    }
    putOnPlanes(domain_.planes, assembled.mesh);
    const MeshFaults faults = findFaults(assembled.mesh);
    if (!faults.none())
    {
      return Outcome::internalFault("TetGen gave an invalid mesh: " + faults.text());
    }
    result.mesh = std::move(assembled.mesh);
    remarkUnmeshed(result.mesh, domain_, result.remarks);
    return Outcome::done();
  }

  Outcome refuseInside(const MeshData& inside, MeshingResult& result) const
  {
    result.problemSurface = { inside.points, inside.triangles, inside.trianglePatch };
    for (std::size_t t = 0; t < inside.triangles.size(); ++t)
    {
      result.problems.push_back({ SurfaceFault::InsideFluid, static_cast<Index>(t), None });
    }
    return Outcome::badInput("the surface has " + std::to_string(inside.triangles.size()) +
      " triangles with fluid on both sides, the first at " +
      placeOf(result.problemSurface, 0, domain_.patches) +
      "; give walls without thickness and wakes as sheets, by the second input, or leave them out; of bodies "
      "whose "
      "insides are kept, name all patches");
  }

  const Domain& domain_;
  Domain closed_; // without the sheets
  const MeshingOptions& options_;
  const TetGenWorker& worker_;
};

Outcome explainFailure(
  const Outcome& last, int attempts, const Domain& domain, const Context& context, MeshingResult& result)
{
  DiagnosisOptions options;
  options.nearTolerance = NearForTetGen;
  Diagnosis near = diagnose(domain.surface, options, context);
  std::erase_if(near.faults,
    [](const Fault& f)
    { return f.kind != SurfaceFault::NearSheets && f.kind != SurfaceFault::Intersection; });
  std::string text = last.message;
  if (attempts > 1)
  {
    text += "; so did " + std::to_string(attempts - 1) + " attempts with other tolerances of TetGen";
  }
  if (!near.faults.empty())
  {
    result.problemSurface = domain.surface;
    for (const Fault& fault : near.faults)
    {
      result.problems.insert(result.problems.end(), fault.findings.begin(), fault.findings.end());
    }
    text += ". The reason may be that " + describe(near, domain.surface, domain.patches) +
      "; remesh the surface, part the sheets, or wrap them (vtkSurfaceWrap, ransmesh --wrap)";
  }
  return { last.kind, text };
}

// failures: of the attempts before, a line each.
void remarkOnSwitches(const std::string& failures, MeshingResult& result)
{
  if (!failures.empty())
  {
    result.remarks.push_back("TetGen needed more than one attempt and succeeded with the switches " +
      result.switches + "; before:" + failures);
  }
  if (result.switches.ends_with("D1"))
  {
    result.remarks.emplace_back(
      "The mesh is made without refining, as the last resort: sizes and quality are poor. SurfaceEdgeLength "
      "(ransmesh --surface-size) remeshes the surface");
  }
}
} // namespace

Outcome meshDomain(const Domain& domain, const MeshingOptions& options, const TetGenWorker& worker,
  const Context& context, MeshingResult& result)
{
  const Attempt attempt(domain, options, worker);
  double reached = 0; // progress does not fall back when an attempt begins anew
  Context steady = context;
  steady.progress = [&](double fraction, const char* phase)
  {
    reached = std::max(reached, fraction);
    context.report(reached, phase);
  };
  std::string failures;
  int attempts = 0;
  TetGenEnd end;
  for (const Variant& variant : Variants)
  {
    if (variant.refines && (result.isEndless || !options.refine))
    {
      continue;
    }
    end = attempt.run(variant, steady, result);
    result.isEndless = result.isEndless || end.endless;
    ++attempts;
    const bool isFinal = end.exhausted || end.outcome.kind == Outcome::Kind::Cancelled;
    if (end.outcome.ok() || isFinal || !result.problems.empty())
    {
      break;
    }
    failures += "\n" + end.outcome.message;
  }
  if (end.outcome.ok())
  {
    remarkOnSwitches(failures, result);
  }
  const bool isUnexplained = end.outcome.kind == Outcome::Kind::BadInput && result.problems.empty();
  return isUnexplained && !end.exhausted ? explainFailure(end.outcome, attempts, domain, context, result)
                                         : end.outcome;
}
} // namespace ransmesh

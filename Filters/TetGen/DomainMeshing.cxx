#include "DomainMeshing.h"

#include "TetGenResult.h"

#include "Boundary/SurfaceEdges.h"
#include "Boundary/SurfaceSizes.h"
#include "Mesh/Validation.h"

#include <algorithm>
#include <cstdio>
#include <set>

namespace ransmesh
{
namespace
{
// The attempts, from the usual to the tolerant. -Y keeps the surface's triangles; without it TetGen splits
// wall triangles, and does not end on some good bodies (measured). -T: the tolerance of coplanarity. -D1:
// no points are inserted; the last resort where refining does not end.
struct Variant
{
  const char* switches;
  bool refines;
};
constexpr Variant Variants[] = { { "Y", true }, { "YT1e-12", true }, { "YT1e-12D1", false } };

Context within(const Context& context, double from, double to)
{
  Context part = context;
  part.progress = [&context, from, to](double fraction, const char* phase)
  { context.report(from + fraction * (to - from), phase); };
  return part;
}

void addPolygon(worker::Request& request, const std::vector<int>& corners, int marker)
{
  request.corners.insert(request.corners.end(), corners.begin(), corners.end());
  request.offsets.push_back(static_cast<std::int32_t>(request.corners.size()));
  request.markers.push_back(marker);
}

void addPoint(worker::Request& request, const Vector3& p)
{
  request.points.insert(request.points.end(), { p.x, p.y, p.z });
}

void addBox(worker::Request& request, const FarFieldBox& box)
{
  const auto first = static_cast<int>(request.points.size() / 3);
  for (const Vector3& corner : box.corners)
  {
    addPoint(request, corner);
  }
  for (int side = 0; side < 6; ++side)
  {
    std::vector<int> corners;
    for (const int c : box.sides[side])
    {
      corners.push_back(first + c);
    }
    addPolygon(request, corners, box.patches[side]);
    request.freeMarkers.push_back(box.patches[side]);
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (!(corner >> axis & 1))
      {
        request.freeSides.insert(request.freeSides.end(), { first + corner, first + (corner | 1 << axis) });
      }
    }
  }
}

worker::Request describeDomain(const SurfaceMesh& surface, const std::optional<FarFieldBox>& box)
{
  worker::Request request;
  for (const Vector3& p : surface.points)
  {
    addPoint(request, p);
  }
  request.offsets.push_back(0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto& v = surface.triangles[t];
    addPolygon(request, { v[0], v[1], v[2] }, surface.patch[t]);
  }
  if (box)
  {
    addBox(request, *box);
  }
  return request;
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

void remarkUnmeshed(const MeshData& mesh, const SurfaceMesh& surface, const PatchTable& patches,
  std::vector<std::string>& remarks)
{
  const std::set<int> meshed(mesh.trianglePatch.begin(), mesh.trianglePatch.end());
  for (const int patch : std::set<int>(surface.patch.begin(), surface.patch.end()))
  {
    if (!meshed.contains(patch))
    {
      remarks.push_back(
        "patch '" + patches[patch].name + "' lies inside a body and bounds no fluid: left out");
    }
  }
}

class Attempt
{
public:
  Attempt(const SurfaceMesh& surface, const std::optional<FarFieldBox>& box, const PatchTable& patches,
    const MeshingOptions& options, const TetGenWorker& worker)
    : surface_(surface)
    , box_(box)
    , patches_(patches)
    , options_(options)
    , worker_(worker)
  {
  }

  TetGenEnd run(const Variant& variant, const Context& context, MeshingResult& result) const
  {
    worker::Request request = describeDomain(surface_, box_);
    double begin = 0;
    if (box_ || mayHaveHoles(surface_))
    {
      begin = 0.2;
      request.switches = std::string("pA") + variant.switches;
      worker::Result regions;
      TetGenEnd end = worker_.run(request, within(context, 0, begin), regions);
      if (!end.outcome.ok())
      {
        return end;
      }
      for (const Vector3& hole : findHoles(regions))
      {
        request.holes.insert(request.holes.end(), { hole.x, hole.y, hole.z });
      }
    }
    request.switches = qualitySwitches(variant);
    describeSizes(surface_, options_.limits, request);
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
    AssembledMesh assembled = assemble(raw);
    if (assembled.mesh.tetrahedra.empty())
    {
      return Outcome::badInput("the surface encloses no volume");
    }
    if (!assembled.sheets.triangles.empty())
    {
      return refuseSheets(assembled.sheets, result);
    }
    const MeshFaults faults = findFaults(assembled.mesh);
    if (!faults.none())
    {
      return Outcome::internalFault("TetGen gave an invalid mesh: " + faults.text());
    }
    result.mesh = std::move(assembled.mesh);
    remarkUnmeshed(result.mesh, surface_, patches_, result.remarks);
    return Outcome::done();
  }

  Outcome refuseSheets(const MeshData& sheets, MeshingResult& result) const
  {
    result.problemSurface = { sheets.points, sheets.triangles, sheets.trianglePatch };
    for (std::size_t t = 0; t < sheets.triangles.size(); ++t)
    {
      result.problems.push_back({ SurfaceFault::InsideFluid, static_cast<Index>(t), None });
    }
    return Outcome::badInput("the surface has " + std::to_string(sheets.triangles.size()) +
      " triangles with fluid on both sides, the first at " + placeOf(result.problemSurface, 0, patches_) +
      "; walls without thickness and interfaces between regions cannot be meshed: give them a thickness, " +
      "or leave them out");
  }

  const SurfaceMesh& surface_;
  const std::optional<FarFieldBox>& box_;
  const PatchTable& patches_;
  const MeshingOptions& options_;
  const TetGenWorker& worker_;
};
} // namespace

Outcome meshDomain(const SurfaceMesh& surface, const std::optional<FarFieldBox>& box,
  const PatchTable& patches, const MeshingOptions& options, const TetGenWorker& worker,
  const Context& context, MeshingResult& result)
{
  const Attempt attempt(surface, box, patches, options, worker);
  double reached = 0; // progress does not fall back when an attempt begins anew
  Context steady = context;
  steady.progress = [&](double fraction, const char* phase)
  {
    reached = std::max(reached, fraction);
    context.report(reached, phase);
  };
  std::string failures;
  TetGenEnd end;
  for (const Variant& variant : Variants)
  {
    if (end.endless && variant.refines)
    {
      continue;
    }
    end = attempt.run(variant, steady, result);
    if (end.outcome.ok() || end.outcome.kind == Outcome::Kind::Cancelled || !result.problems.empty())
    {
      break;
    }
    failures += "\n" + end.outcome.message;
  }
  if (end.outcome.ok() && !failures.empty())
  {
    result.remarks.push_back("TetGen needed more than one attempt and succeeded with the switches " +
      result.switches +
      (result.switches.ends_with("D1") ? " (without refining: sizes and quality are poor)" : "") +
      "; before:" + failures);
  }
  return end.outcome;
}
} // namespace ransmesh

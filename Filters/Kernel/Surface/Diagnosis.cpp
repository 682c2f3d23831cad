#include "Surface/Diagnosis.h"

#include "Surface/ProximityFaults.h"
#include "Surface/TopologyFaults.h"
#include "Triangles/SurfaceRepair.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
// Some of the triangles of a surface, with their numbers there.
struct Part
{
  SurfaceMesh surface;
  std::vector<Index> numbers;
};

template <class Keep>
Part partOf(const SurfaceMesh& surface, Keep keep)
{
  Part part;
  part.surface.points = surface.points;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (keep(static_cast<Index>(t)))
    {
      part.surface.triangles.push_back(surface.triangles[t]);
      part.surface.patch.push_back(surface.patch[t]);
      part.numbers.push_back(static_cast<Index>(t));
    }
  }
  return part;
}

Fault inTheWhole(Fault fault, const std::vector<Index>& numbers)
{
  for (SurfaceFinding& finding : fault.findings)
  {
    finding.triangle = numbers[finding.triangle];
    finding.partner = finding.partner == None ? None : numbers[finding.partner];
  }
  for (auto& [s, t] : fault.pairs)
  {
    s = numbers[s];
    t = numbers[t];
  }
  return fault;
}

Fault findNotFinite(const SurfaceMesh& surface)
{
  Fault fault;
  fault.kind = SurfaceFault::NotFinite;
  std::vector<char> isCounted(surface.points.size(), 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    bool faulty = false;
    for (const Index v : surface.triangles[t])
    {
      if (!isUsable(surface.points[v]))
      {
        faulty = true;
        fault.where = fault.count == 0 ? surface.points[v] : fault.where;
        fault.count += isCounted[v] == 0;
        isCounted[v] = 1;
      }
    }
    if (faulty)
    {
      fault.findings.push_back({ fault.kind, static_cast<Index>(t), None });
    }
  }
  return fault;
}

Fault findDegenerate(const SurfaceMesh& surface)
{
  Fault fault;
  fault.kind = SurfaceFault::Degenerate;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (isDegenerate(surface, static_cast<Index>(t)))
    {
      fault.findings.push_back({ fault.kind, static_cast<Index>(t), None });
    }
  }
  fault.count = fault.findings.size();
  fault.where = fault.count > 0 ? centreOf(surface, fault.findings[0].triangle) : Vector3();
  return fault;
}

class Examination
{
public:
  Examination(const DiagnosisOptions& options, const Context& context)
    : options_(options)
    , context_(context)
  {
  }

  Diagnosis run(SurfaceMesh surface)
  {
    diagnosis_.triangles = surface.triangles.size();
    add(findNotFinite(surface));
    if (!diagnosis_.faults.empty())
    {
      return std::move(diagnosis_);
    }
    mergeEqualPoints(surface);
    diagnosis_.points = surface.points.size();
    diagnosis_.extent = extentOf(surface.points);
    const Fault degenerate = findDegenerate(surface);
    add(degenerate);
    examineTopology(surface);
    context_.report(0.3, "looking for intersections");
    if (options_.intersections && !context_.stopped())
    {
      examineProximity(surface, degenerate);
    }
    std::stable_sort(diagnosis_.faults.begin(), diagnosis_.faults.end(),
      [](const Fault& f, const Fault& g) { return f.kind < g.kind; });
    return std::move(diagnosis_);
  }

private:
  void add(Fault fault)
  {
    if (fault.count > 0)
    {
      diagnosis_.faults.push_back(std::move(fault));
    }
  }

  void examineTopology(const SurfaceMesh& surface)
  {
    const Part part = partOf(surface,
      [&surface](Index t)
      {
        const auto& v = surface.triangles[t];
        return v[0] != v[1] && v[1] != v[2] && v[2] != v[0];
      });
    add(inTheWhole(findOpenEdges(part.surface, options_.closedBy), part.numbers));
    for (const auto find : { findDuplicates, findNonManifoldEdges, findNonManifoldPoints, findTurned })
    {
      add(inTheWhole(find(part.surface), part.numbers));
    }
    diagnosis_.pieces = findPieces(part.surface);
  }

  void examineProximity(const SurfaceMesh& surface, const Fault& degenerate)
  {
    std::vector<char> isFlat(surface.triangles.size(), 0);
    for (const SurfaceFinding& finding : degenerate.findings)
    {
      isFlat[finding.triangle] = 1;
    }
    const Part part = partOf(surface, [&isFlat](Index t) { return !isFlat[t]; });
    const Fault crossings = findCrossings(part.surface);
    add(inTheWhole(crossings, part.numbers));
    const double distance = options_.nearTolerance * diagnosis_.extent.largestLength();
    if (distance > 0 && !context_.stopped())
    {
      context_.report(0.7, "looking for near sheets");
      add(inTheWhole(findNearSheets(part.surface, distance, crossings.pairs), part.numbers));
    }
  }

  const DiagnosisOptions& options_;
  const Context& context_;
  Diagnosis diagnosis_;
};
} // namespace

const Fault* Diagnosis::find(SurfaceFault kind) const
{
  const auto same = [kind](const Fault& fault) { return fault.kind == kind; };
  const auto place = std::find_if(faults.begin(), faults.end(), same);
  return place == faults.end() ? nullptr : &*place;
}

std::size_t Diagnosis::count(SurfaceFault kind) const
{
  const Fault* fault = find(kind);
  return fault ? fault->count : 0;
}

bool Diagnosis::isSound() const
{
  return std::none_of(
    faults.begin(), faults.end(), [](const Fault& fault) { return preventsMeshing(fault.kind); });
}

Diagnosis diagnose(const SurfaceMesh& surface, const DiagnosisOptions& options, const Context& context)
{
  return Examination(options, context).run(surface);
}
} // namespace ransmesh

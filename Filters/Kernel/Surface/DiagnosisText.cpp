#include "Surface/DiagnosisText.h"

#include "Surface/ProximityFaults.h"

#include <algorithm>
#include <map>
#include <set>

namespace ransmesh
{
namespace
{
constexpr std::size_t MostNames = 4; // in one sentence
constexpr SurfaceFault ByGravity[] = { SurfaceFault::NotFinite, SurfaceFault::OpenEdge,
  SurfaceFault::Intersection, SurfaceFault::Degenerate, SurfaceFault::Duplicate,
  SurfaceFault::NonManifoldEdge, SurfaceFault::NonManifoldPoint, SurfaceFault::Turned,
  SurfaceFault::NearSheets };

std::string counted(std::size_t n, const char* one, const char* many)
{
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

std::string quoted(const std::string& name)
{
  return "'" + name + "'";
}

std::string namesOf(const std::set<int>& numbers, const PatchTable& patches)
{
  std::string text;
  std::size_t named = 0;
  for (const int patch : numbers)
  {
    if (named == MostNames)
    {
      return text + " and " + std::to_string(numbers.size() - named) + " more";
    }
    const bool isLast = named + 1 == numbers.size();
    text += (named == 0 ? "" : isLast ? " and " : ", ") + quoted(patches[patch].name);
    ++named;
  }
  return text;
}

std::set<int> patchesOf(const Fault& fault, const SurfaceMesh& surface)
{
  std::set<int> numbers;
  for (const SurfaceFinding& finding : fault.findings)
  {
    numbers.insert(surface.patch[finding.triangle]);
  }
  return numbers;
}

// Pairs of triangles, by the patches that they belong to.
struct PairGroup
{
  std::set<int> patches; // one, or two
  std::size_t pairs = 0;
  std::set<Index> triangles;
  Vector3 where;
};

std::vector<PairGroup> groupsOf(const Fault& fault, const SurfaceMesh& surface)
{
  std::map<std::set<int>, PairGroup> groups;
  for (const auto& [s, t] : fault.pairs)
  {
    const std::set<int> key = { surface.patch[s], surface.patch[t] };
    PairGroup& group = groups[key];
    if (group.pairs++ == 0)
    {
      group.where =
        fault.kind == SurfaceFault::Intersection ? meetingPlace(surface, s, t) : centreOf(surface, s);
    }
    group.patches = key;
    group.triangles.insert({ s, t });
  }
  std::vector<PairGroup> sorted;
  sorted.reserve(groups.size());
  for (auto& [key, group] : groups)
  {
    sorted.push_back(std::move(group));
  }
  std::stable_sort(
    sorted.begin(), sorted.end(), [](const PairGroup& g, const PairGroup& h) { return g.pairs > h.pairs; });
  return sorted;
}

std::string describePairs(
  const Fault& fault, const SurfaceMesh& surface, const PatchTable& patches, const char* doWhat)
{
  std::string text;
  std::size_t told = 0;
  const std::vector<PairGroup> groups = groupsOf(fault, surface);
  for (const PairGroup& group : groups)
  {
    if (told == MostNames)
    {
      return text + ", and so on (" + std::to_string(groups.size()) + " pairs of patches)";
    }
    text += (told++ == 0 ? "" : ", ") + counted(group.triangles.size(), "triangle", "triangles") + " of " +
      namesOf(group.patches, patches) + " " + doWhat + " near " + placeOf(group.where);
  }
  return text;
}

std::string placeAndPatches(const Fault& fault, const SurfaceMesh& surface, const PatchTable& patches)
{
  const std::set<int> numbers = patchesOf(fault, surface);
  return (fault.count == 1 ? std::string(" at ") : std::string(", the first at ")) + placeOf(fault.where) +
    (numbers.size() == 1 ? " in patch " : " in patches ") + namesOf(numbers, patches);
}

std::string countText(const Fault& fault)
{
  const std::size_t n = fault.count;
  switch (fault.kind)
  {
    case SurfaceFault::NotFinite:
      return counted(n, "point that is", "points that are") +
        " not finite, or too far away to compute with (limit 1e50; check the units)";
    case SurfaceFault::Degenerate:
      return counted(n, "degenerate triangle", "degenerate triangles") + " (no area)";
    case SurfaceFault::Duplicate:
      return counted(n, "duplicate triangle", "duplicate triangles");
    case SurfaceFault::OpenEdge:
      return counted(n, "open edge", "open edges");
    case SurfaceFault::NonManifoldEdge:
      return counted(n, "non-manifold edge", "non-manifold edges") + " (of more than two triangles)";
    case SurfaceFault::NonManifoldPoint:
      return counted(n, "non-manifold point", "non-manifold points") + " (where parts touch in a point)";
    case SurfaceFault::Turned:
      return counted(n, "misoriented edge", "misoriented edges") + " (" +
        counted(fault.findings.size(), "triangle runs", "triangles run") + " against the neighbours)";
    case SurfaceFault::Intersection:
      return counted(n, "pair of triangles cuts or touches", "pairs of triangles cut or touch") +
        " each other";
    case SurfaceFault::NearSheets:
      return counted(n, "pair of triangles that nearly touch", "pairs of triangles that nearly touch") +
        " each other";
    default:
      return counted(n, "sheet", "sheets") + " inside the fluid";
  }
}

std::string describe(const Fault& fault, const SurfaceMesh& surface, const PatchTable& patches)
{
  const bool ofPairs = fault.kind == SurfaceFault::Intersection || fault.kind == SurfaceFault::NearSheets;
  const char* doWhat = fault.kind == SurfaceFault::Intersection ? "cross" : "nearly touch";
  const std::string lead = fault.kind == SurfaceFault::OpenEdge ? "is not closed: "
    : fault.kind == SurfaceFault::Intersection                  ? "intersects itself: "
                                                                : "has ";
  return lead + countText(fault) +
    (ofPairs ? ": " + describePairs(fault, surface, patches, doWhat)
             : placeAndPatches(fault, surface, patches));
}
} // namespace

std::vector<FaultRow> faultRows(
  const Diagnosis& diagnosis, const SurfaceMesh& surface, const PatchTable& patches)
{
  std::vector<FaultRow> rows;
  for (const Fault& fault : diagnosis.faults)
  {
    const std::string kind(SurfaceFaultNames[static_cast<std::size_t>(fault.kind)]);
    if (fault.pairs.empty())
    {
      rows.push_back({ kind, fault.count, fault.findings.size(), namesOf(patchesOf(fault, surface), patches),
        fault.where });
    }
    for (const PairGroup& group : groupsOf(fault, surface))
    {
      rows.push_back(
        { kind, group.pairs, group.triangles.size(), namesOf(group.patches, patches), group.where });
    }
  }
  return rows;
}

std::string describe(const Diagnosis& diagnosis, const SurfaceMesh& surface, const PatchTable& patches)
{
  std::string text;
  for (const SurfaceFault kind : ByGravity)
  {
    if (const Fault* fault = diagnosis.find(kind))
    {
      text += (text.empty() ? "the surface " : "; it ") + describe(*fault, surface, patches);
    }
  }
  return text;
}
} // namespace ransmesh

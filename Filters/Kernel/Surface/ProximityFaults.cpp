#include "Surface/ProximityFaults.h"

#include "Geometry/Distance.h"
#include "Triangles/NearTriangles.h"
#include "Triangles/SurfaceIntersections.h"

#include <algorithm>
#include <limits>
#include <map>

namespace ransmesh
{
namespace
{
using Pair = std::pair<Index, Index>;

constexpr std::size_t MostPairs = 1000000; // more would say no more and fill the memory

// The findings about the pairs: each triangle once, with the first that it meets.
std::vector<SurfaceFinding> findingsOf(SurfaceFault kind, const std::vector<Pair>& pairs)
{
  std::map<Index, Index> partnerOf;
  for (const auto& [s, t] : pairs)
  {
    partnerOf.emplace(s, t);
    partnerOf.emplace(t, s);
  }
  std::vector<SurfaceFinding> findings;
  findings.reserve(partnerOf.size());
  for (const auto& [triangle, partner] : partnerOf)
  {
    findings.push_back({ kind, triangle, partner });
  }
  return findings;
}

// Where a side of one triangle passes through the other.
class Meeting
{
public:
  explicit Meeting(const SurfaceMesh& surface)
    : surface_(surface)
  {
  }

  Vector3 of(Index s, Index t)
  {
    least_ = std::numeric_limits<double>::max();
    place_ = centreOf(surface_, s);
    trySides(s, t);
    trySides(t, s);
    return place_;
  }

private:
  const Vector3& corner(Index t, int i) const { return surface_.points[surface_.triangles[t][i]]; }

  void trySides(Index sides, Index plane)
  {
    const Vector3& a = corner(plane, 0);
    const Vector3& b = corner(plane, 1);
    const Vector3& c = corner(plane, 2);
    const Vector3 normal = cross(b - a, c - a);
    for (int i = 0; i < 3; ++i)
    {
      const Vector3& p = corner(sides, i);
      const Vector3& q = corner(sides, (i + 1) % 3);
      const double hp = dot(normal, p - a);
      const double hq = dot(normal, q - a);
      if (hp * hq > 0 || hp == hq)
      {
        continue;
      }
      const Vector3 x = p + (hp / (hp - hq)) * (q - p);
      const double off = distanceToTriangle(x, a, b, c);
      if (off < least_)
      {
        least_ = off;
        place_ = x;
      }
    }
  }

  const SurfaceMesh& surface_;
  double least_ = 0;
  Vector3 place_;
};
} // namespace

Fault findCrossings(const SurfaceMesh& surface)
{
  Fault fault;
  fault.kind = SurfaceFault::Intersection;
  fault.pairs = findIntersections(surface, MostPairs);
  fault.count = fault.pairs.size();
  fault.findings = findingsOf(fault.kind, fault.pairs);
  if (fault.count > 0)
  {
    fault.where = meetingPlace(surface, fault.pairs[0].first, fault.pairs[0].second);
  }
  return fault;
}

Vector3 meetingPlace(const SurfaceMesh& surface, Index s, Index t)
{
  return Meeting(surface).of(s, t);
}

Fault findNearSheets(
  const SurfaceMesh& surface, double distance, const std::vector<std::pair<Index, Index>>& crossing)
{
  Fault fault;
  fault.kind = SurfaceFault::NearSheets;
  fault.pairs = findNearTriangles(surface, distance, MostPairs);
  std::erase_if(fault.pairs,
    [&crossing](const Pair& pair) { return std::binary_search(crossing.begin(), crossing.end(), pair); });
  fault.count = fault.pairs.size();
  fault.findings = findingsOf(fault.kind, fault.pairs);
  fault.where = fault.count > 0 ? centreOf(surface, fault.pairs[0].first) : Vector3();
  return fault;
}
} // namespace ransmesh

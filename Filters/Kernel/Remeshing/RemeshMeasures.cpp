#include "Remeshing/RemeshMeasures.h"

#include "Triangles/SurfaceTriangles.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
void measureAngles(const SurfaceMesh& made, RemeshingReport& report)
{
  std::vector<double> angles;
  angles.reserve(made.triangles.size());
  for (const auto& t : made.triangles)
  {
    angles.push_back(smallestAngle(made, t));
  }
  if (!angles.empty())
  {
    const auto low = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 100);
    std::nth_element(angles.begin(), low, angles.end());
    report.lowAngle = *low;
    report.smallestAngle = *std::min_element(angles.begin(), low + 1);
  }
}
} // namespace

RemeshingReport measureRemeshing(const SurfaceReference& given, const SurfaceMesh& made, double featureAngle)
{
  RemeshingReport report;
  report.trianglesBefore = given.surface().triangles.size();
  report.trianglesAfter = made.triangles.size();
  measureAngles(made, report);
  const SurfaceReference back(EditableSurface(made, featureAngle));
  const SurfaceDeviation there = deviationFrom(given, made);
  const SurfaceDeviation here = deviationFrom(back, given.surface());
  report.largestDeviation = std::max(there.largest, here.largest);
  report.deviationPlace = there.largest > here.largest ? there.place : here.place;
  report.meanDeviation = std::max(there.mean, here.mean);
  return report;
}
} // namespace ransmesh

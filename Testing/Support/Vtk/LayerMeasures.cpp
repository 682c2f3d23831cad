#include "Vtk/LayerMeasures.h"

#include "Mesh/FaceMatching.h"
#include "Quality/WallPoints.h"

#include <vtkDataArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace chain_run
{
double areaWithFirstHeight(const ransmesh::MeshData& mesh, const ransmesh::LayerPlan& plan)
{
  const ransmesh::FaceMatching matching = ransmesh::matchFaces(mesh);
  double area = 0;
  double good = 0;
  for (const ransmesh::MeasuredWallFace& face :
    ransmesh::wallFacesOf(mesh, ransmesh::innerFacesOf(mesh, matching), plan))
  {
    const double ratio = face.cellHeight / plan[face.patch].firstHeight;
    area += face.area;
    good += ratio > 0.9 && ratio < 1.1 ? face.area : 0;
  }
  return area > 0 ? good / area : 0;
}

namespace
{
double offTheRates(double growth, const ransmesh::LayerPlan& plan)
{
  double off = std::numeric_limits<double>::infinity();
  for (const ransmesh::LayerSpecification& specification : plan)
  {
    off = specification.hasLayers() ? std::min(off, std::fabs(growth / specification.growthRate - 1)) : off;
  }
  return off;
}
} // namespace

double growthOff(const ransmesh::MeshData& mesh, vtkDataArray* column, const ransmesh::LayerPlan& plan)
{
  int layers = 0;
  for (const ransmesh::LayerSpecification& specification : plan)
  {
    layers = std::max(layers, specification.numberOfLayers);
  }
  std::map<int, std::vector<std::size_t>> pointsOf; // from the wall outward
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    pointsOf[static_cast<int>(column->GetTuple1(static_cast<vtkIdType>(i)))].push_back(i);
  }
  std::vector<double> off;
  for (auto& [number, points] : pointsOf)
  {
    if (number < 0 || points.size() > static_cast<std::size_t>(layers) + 1)
    {
      continue;
    }
    const auto toFirst = [&](std::size_t i)
    { return distance(mesh.points[points[0]], mesh.points[points[i]]); };
    if (points.size() > 1 && toFirst(points.size() - 1) < toFirst(1))
    {
      std::rotate(points.begin(), points.begin() + 1, points.end()); // in a fan, that begins with its top
    }
    for (std::size_t i = 2; i < points.size(); ++i)
    {
      const double last = distance(mesh.points[points[i - 2]], mesh.points[points[i - 1]]);
      const double next = distance(mesh.points[points[i - 1]], mesh.points[points[i]]);
      off.push_back(offTheRates(next / last, plan));
    }
  }
  if (off.empty())
  {
    return 0;
  }
  const auto place = off.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(off.size() - 1));
  std::nth_element(off.begin(), place, off.end());
  return *place;
}
} // namespace chain_run

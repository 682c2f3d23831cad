#include "Vtk/LayerMeasures.h"

#include "Layers/Column.h"
#include "Mesh/FaceMatching.h"
#include "Quality/ColumnFollower.h"
#include "Quality/WallPoints.h"
#include "Support/DataContract.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace chain_run
{
namespace
{
namespace contract = ransmesh::contract;

std::vector<ransmesh::MeasuredWallFace> wallsOf(
  const ransmesh::MeshData& mesh, const ransmesh::LayerPlan& plan)
{
  const ransmesh::FaceMatching matching = ransmesh::matchFaces(mesh);
  return ransmesh::wallFacesOf(mesh, ransmesh::innerFacesOf(mesh, matching), plan);
}
} // namespace

std::vector<int> levelsInGaps(const ransmesh::MeshData& mesh, vtkPolyData* boundary)
{
  vtkDataArray* achieved = boundary->GetPointData()->GetArray(contract::LayersAchieved);
  vtkDataArray* reason = boundary->GetPointData()->GetArray(contract::StopReason);
  std::map<std::array<double, 3>, int> levels; // by place, which points of walls keep
  for (vtkIdType i = 0; i < boundary->GetNumberOfPoints(); ++i)
  {
    if (static_cast<ransmesh::StopReason>(static_cast<int>(reason->GetTuple1(i))) ==
      ransmesh::StopReason::Gap)
    {
      std::array<double, 3> place{};
      boundary->GetPoint(i, place.data());
      levels[place] = static_cast<int>(achieved->GetTuple1(i));
    }
  }
  std::vector<int> inGaps;
  inGaps.reserve(mesh.points.size());
  for (const ransmesh::Vector3& p : mesh.points)
  {
    const auto found = levels.find({ p.x, p.y, p.z });
    inGaps.push_back(found == levels.end() ? -1 : found->second);
  }
  return inGaps;
}

FirstHeightShares firstHeightShares(
  const ransmesh::MeshData& mesh, const ransmesh::LayerPlan& plan, const std::vector<int>& inGaps)
{
  double area = 0;
  double good = 0;
  double areaAway = 0;
  double goodAway = 0;
  for (const ransmesh::MeasuredWallFace& face : wallsOf(mesh, plan))
  {
    const double ratio = face.cellHeight / plan[face.patch].firstHeight;
    const double ofGood = ratio > 0.9 && ratio < 1.1 ? face.area : 0;
    const bool away = std::all_of(
      face.vertex.begin(), face.vertex.end(), [&inGaps](ransmesh::Index v) { return inGaps[v] < 0; });
    area += face.area;
    good += ofGood;
    areaAway += away ? face.area : 0;
    goodAway += away ? ofGood : 0;
  }
  return { area > 0 ? good / area : 0, areaAway > 0 ? goodAway / areaAway : 1 };
}

double columnsWithTheirLayers(
  const ransmesh::MeshData& mesh, const ransmesh::LayerPlan& plan, const std::vector<int>& inGaps)
{
  constexpr double smoothAngle = 20; // degrees
  const ransmesh::ColumnFollower follower(mesh, {});
  std::vector<ransmesh::LayerHeights> heights;
  for (const ransmesh::LayerSpecification& s : plan)
  {
    heights.emplace_back(s);
  }
  std::size_t points = 0;
  std::size_t complete = 0;
  ransmesh::FoundColumn column;
  for (const ransmesh::ColumnFoot& foot : ransmesh::columnFeetOf(mesh, wallsOf(mesh, plan), smoothAngle))
  {
    if (foot.isSmooth)
    {
      follower.follow(foot, heights[foot.patch], column);
      const int left = inGaps[foot.point];
      complete += column.layers() >= (left < 0 ? heights[foot.patch].count() : left);
      ++points;
    }
  }
  return points > 0 ? static_cast<double>(complete) / static_cast<double>(points) : 0;
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

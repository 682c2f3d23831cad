#include "Quality/WallAssessment.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
// What is gathered before it is summed up, for one wall or for all.
struct WallSamples
{
  WallSummary summary;
  double goodArea = 0;
  std::size_t full = 0;
  std::vector<double> firstHeight;
  std::vector<double> firstHeightRatio;
  std::vector<double> growth;
  std::vector<double> lean;
  std::vector<double> transition;
  std::vector<double> topToWallEdge;
};

void addFace(const MeasuredWallFace& face, double asked, double tolerance, WallSamples& wall)
{
  ++wall.summary.faces;
  wall.summary.area += face.area;
  wall.firstHeight.push_back(face.cellHeight);
  wall.firstHeightRatio.push_back(face.cellHeight / asked);
  if (face.cellHeight > asked / tolerance && face.cellHeight < asked * tolerance)
  {
    wall.goodArea += face.area;
  }
}

void addColumn(const ColumnFoot& foot, const FoundColumn& column, int asked, WallSamples& wall)
{
  ++wall.summary.smoothPoints;
  auto& byLayers = wall.summary.columnsByLayers;
  byLayers.resize(std::max<std::size_t>(byLayers.size(), asked + 1), 0);
  ++byLayers[column.layers()];
  wall.full += column.layers() == asked;
  wall.lean.insert(wall.lean.end(), column.leans.begin(), column.leans.end());
  for (std::size_t i = 1; i < column.spacings.size(); ++i)
  {
    wall.growth.push_back(column.spacings[i] / column.spacings[i - 1]);
  }
  if (column.spacings.empty())
  {
    return;
  }
  wall.topToWallEdge.push_back(column.spacings.back() / foot.wallEdge);
  if (column.edgeBeyond > 0)
  {
    wall.transition.push_back(column.edgeBeyond / column.spacings.back());
  }
}

double meanLayers(const std::vector<std::size_t>& columnsByLayers)
{
  double columns = 0;
  double layers = 0;
  for (std::size_t n = 0; n < columnsByLayers.size(); ++n)
  {
    columns += static_cast<double>(columnsByLayers[n]);
    layers += static_cast<double>(n * columnsByLayers[n]);
  }
  return columns > 0 ? layers / columns : 0;
}

Histogram layersHistogram(const WallSummary& wall)
{
  Histogram histogram;
  for (std::size_t n = 0; n < wall.columnsByLayers.size(); ++n)
  {
    histogram.low.push_back(static_cast<double>(n));
    histogram.high.push_back(static_cast<double>(n + 1));
  }
  histogram.count = wall.columnsByLayers;
  return histogram;
}

void label(Histogram histogram, const char* quantity, const char* unit, const std::string& scope,
  std::vector<Histogram>& into)
{
  histogram.quantity = quantity;
  histogram.unit = unit;
  histogram.scope = scope;
  into.push_back(std::move(histogram));
}

void addHistograms(const WallSamples& wall, std::vector<Histogram>& into)
{
  const std::string& scope = wall.summary.name;
  label(layersHistogram(wall.summary), "LayersPerColumn", "columns", scope, into);
  if (wall.summary.patch == 0)
  {
    label(evenHistogram(wall.firstHeightRatio, 0, 4, 40), "FirstHeightAchievedOverAsked", "wall faces", scope,
      into);
    label(evenHistogram(wall.growth, 0.5, 2.5, 40), "GrowthAchieved", "column edges", scope, into);
    label(evenHistogram(wall.lean, 0, 20, 20), "ColumnLean", "column edges", scope, into);
    label(evenHistogram(wall.transition, 0, 10, 40), "Transition", "columns", scope, into);
  }
}

WallSummary sumUp(WallSamples& wall)
{
  WallSummary& s = wall.summary;
  const auto columns = static_cast<double>(std::max<std::size_t>(s.smoothPoints, 1));
  s.areaShareWithFirstHeight = s.area > 0 ? wall.goodArea / s.area : 0;
  s.meanLayers = meanLayers(s.columnsByLayers);
  s.shareFull = static_cast<double>(wall.full) / columns;
  s.shareEmpty = s.columnsByLayers.empty() ? 0 : static_cast<double>(s.columnsByLayers.front()) / columns;
  s.firstHeight = quantilesOf(std::move(wall.firstHeight));
  s.firstHeightRatio = quantilesOf(std::move(wall.firstHeightRatio));
  s.growth = quantilesOf(std::move(wall.growth));
  s.lean = quantilesOf(std::move(wall.lean));
  s.transition = quantilesOf(std::move(wall.transition));
  s.topToWallEdge = quantilesOf(std::move(wall.topToWallEdge));
  return s;
}

// By patch number, with all walls together in row 0.
std::vector<WallSamples> emptySamples(const ReportSubject& subject)
{
  std::vector<WallSamples> walls(subject.plan.size());
  walls[0].summary.name = "whole";
  for (std::size_t i = 1; i < walls.size(); ++i)
  {
    walls[i].summary.patch = static_cast<int>(i);
    walls[i].summary.asked = subject.plan[i];
    walls[i].summary.name =
      i < subject.patches.size() ? subject.patches[i].name : "patch_" + std::to_string(i);
  }
  return walls;
}

std::vector<LayerHeights> heightsOf(const LayerPlan& plan)
{
  std::vector<LayerHeights> heights;
  heights.reserve(plan.size());
  for (const LayerSpecification& s : plan)
  {
    heights.emplace_back(s);
  }
  return heights;
}

void followColumns(const ReportSubject& subject, const std::vector<ColumnFoot>& feet,
  const ReportOptions& options, const Context& context, std::vector<WallSamples>& walls,
  std::vector<char>& onColumn)
{
  const ColumnFollower follower(subject.mesh, options.columns);
  const std::vector<LayerHeights> heights = heightsOf(subject.plan);
  FoundColumn column;
  for (std::size_t i = 0; i < feet.size() && !(i % 4096 == 0 && context.stopped()); ++i)
  {
    const ColumnFoot& foot = feet[i];
    follower.follow(foot, heights[foot.patch], column);
    for (const Index v : column.points)
    {
      onColumn[v] = 1;
    }
    for (WallSamples* wall : { &walls[0], &walls[foot.patch] })
    {
      ++wall->summary.points;
      if (foot.isSmooth)
      {
        addColumn(foot, column, heights[foot.patch].count(), *wall);
      }
    }
  }
}
} // namespace

WallAssessment assessWalls(const ReportSubject& subject, const std::vector<HalfFace>& innerFaces,
  const ReportOptions& options, const Context& context)
{
  WallAssessment result;
  result.onColumn.assign(subject.mesh.points.size(), 0);
  const std::vector<MeasuredWallFace> faces = wallFacesOf(subject.mesh, innerFaces, subject.plan);
  if (faces.empty())
  {
    return result;
  }
  std::vector<WallSamples> walls = emptySamples(subject);
  for (const MeasuredWallFace& face : faces)
  {
    for (WallSamples* wall : { &walls[0], &walls[face.patch] })
    {
      addFace(face, subject.plan[face.patch].firstHeight, options.columns.tolerance, *wall);
    }
  }
  followColumns(subject, columnFeetOf(subject.mesh, faces, options.smoothAngle), options, context, walls,
    result.onColumn);
  for (WallSamples& wall : walls)
  {
    if (wall.summary.faces > 0)
    {
      addHistograms(wall, result.histograms);
      result.walls.push_back(sumUp(wall));
    }
  }
  return result;
}
} // namespace ransmesh

#include "Quality/QualityReport.h"

#include "Quality/SheetAssessment.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
std::vector<PatchSummary> summarizePatches(const MeshData& mesh, const PatchTable& patches)
{
  std::vector<PatchSummary> rows;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const auto patch = static_cast<std::size_t>(mesh.trianglePatch[i]);
    rows.resize(std::max(rows.size(), patch + 1));
    const auto& v = mesh.triangles[i];
    const Vector3& a = mesh.points[v[0]];
    rows[patch].area += norm(cross(mesh.points[v[1]] - a, mesh.points[v[2]] - a)) / 2;
    ++rows[patch].triangles;
  }
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const bool known = i < patches.size();
    rows[i].number = static_cast<int>(i);
    rows[i].name = known ? patches[i].name : "patch_" + std::to_string(i);
    rows[i].type = known ? patches[i].type : PatchType::Patch;
  }
  rows.erase(
    std::remove_if(rows.begin(), rows.end(), [](const PatchSummary& row) { return row.triangles == 0; }),
    rows.end());
  return rows;
}

void tellSheets(const MeshData& mesh, const FaceMatching& matching, std::vector<PatchSummary>& rows)
{
  for (const SheetFace& sheet : matching.sheets)
  {
    const int patch = mesh.trianglePatch[sheet.triangle];
    std::find_if(rows.begin(), rows.end(), [patch](const PatchSummary& row) { return row.number == patch; })
      ->isSheet = true;
  }
}

ShapeSummary summarizeShapes(const CellMeasures& cells)
{
  ShapeSummary shapes;
  shapes.count = cells.count();
  shapes.largestDihedral = quantilesOf(cells.largestDihedral);
  shapes.smallestDihedral = quantilesOf(cells.smallestDihedral);
  shapes.stretching = quantilesOf(cells.stretching);
  shapes.quality = quantilesOf(cells.quality);
  for (std::size_t i = 0; i < ShapeSummary::Limits.size(); ++i)
  {
    const auto over = std::count_if(cells.largestDihedral.begin(), cells.largestDihedral.end(),
      [limit = ShapeSummary::Limits[i]](double angle) { return angle > limit; });
    shapes.shareOver[i] =
      static_cast<double>(over) / static_cast<double>(std::max<std::size_t>(shapes.count, 1));
  }
  return shapes;
}

// The shapes of the tetrahedra in layers.
CellMeasures onlyLayers(
  const ReportSubject& subject, const CellMeasures& cells, const std::vector<char>& onColumn)
{
  CellMeasures layers;
  for (std::size_t t = 0; t < cells.count(); ++t)
  {
    const auto& v = subject.mesh.tetrahedra[t];
    const bool inLayer = subject.layerId
      ? (*subject.layerId)[t] > 0
      : std::all_of(v.begin(), v.end(), [&onColumn](Index p) { return onColumn[p] != 0; });
    if (inLayer)
    {
      layers.volume.push_back(cells.volume[t]);
      layers.largestDihedral.push_back(cells.largestDihedral[t]);
      layers.smallestDihedral.push_back(cells.smallestDihedral[t]);
      layers.stretching.push_back(cells.stretching[t]);
      layers.quality.push_back(cells.quality[t]);
    }
  }
  return layers;
}

std::vector<RegionSummary> summarizeRegions(const ReportSubject& subject, const CellMeasures& cells)
{
  std::map<int, RegionSummary> regions;
  for (std::size_t t = 0; subject.region && t < cells.count(); ++t)
  {
    RegionSummary& region = regions[(*subject.region)[t]];
    ++region.tetrahedra;
    region.volume += cells.volume[t];
  }
  std::vector<RegionSummary> summaries;
  for (auto& [number, region] : regions)
  {
    region.number = number;
    region.name = subject.regionNames.at(number);
    summaries.push_back(std::move(region));
  }
  return summaries.size() > 1 ? summaries : std::vector<RegionSummary>();
}

void addCellHistograms(const CellMeasures& cells, const std::string& scope, std::vector<Histogram>& into)
{
  const auto add = [&](Histogram histogram, const char* quantity)
  {
    histogram.quantity = quantity;
    histogram.unit = "tetrahedra";
    histogram.scope = scope;
    into.push_back(std::move(histogram));
  };
  add(evenHistogram(cells.largestDihedral, 0, 180, 36), "LargestDihedral");
  add(evenHistogram(cells.smallestDihedral, 0, 90, 18), "SmallestDihedral");
  add(decadeHistogram(cells.stretching, 4), "Stretching");
  add(evenHistogram(cells.quality, 0, 1, 20), "Quality");
}

void measureMesh(const ReportSubject& subject, const FaceMatching& matching, const Context& context,
  CellMeasures& cells, QualityReport& report)
{
  context.report(0.3, "measuring the tetrahedra");
  cells = measureCells(subject.mesh);
  cells.innerFace = innerFacesOf(subject.mesh, matching);
  report.volume = totalVolume(subject.mesh);
  report.patches = summarizePatches(subject.mesh, subject.patches);
  tellSheets(subject.mesh, matching, report.patches);
  report.regions = summarizeRegions(subject, cells);
  report.cellVolume = quantilesOf(cells.volume);
  report.longestEdge = quantilesOf(cells.longestEdge);
  report.shortestEdge = quantilesOf(cells.shortestEdge);
  report.all = summarizeShapes(cells);
  addCellHistograms(cells, "whole", report.histograms);
  if (context.stopped())
  {
    return;
  }
  context.report(0.7, "following the layers");
  WallAssessment assessment = assessBothSides(subject, matching, cells.innerFace, report.options, context);
  report.walls = std::move(assessment.walls);
  if (!report.walls.empty() || subject.layerId)
  {
    const CellMeasures layers = onlyLayers(subject, cells, assessment.onColumn);
    report.layers = summarizeShapes(layers);
    addCellHistograms(layers, "layers", report.histograms);
  }
  std::move(
    assessment.histograms.begin(), assessment.histograms.end(), std::back_inserter(report.histograms));
}
} // namespace

QualityReport reportQuality(
  const ReportSubject& subject, const ReportOptions& options, const Context& context, CellMeasures* cells)
{
  QualityReport report;
  report.options = options;
  report.points = subject.mesh.points.size();
  report.tetrahedra = subject.mesh.tetrahedra.size();
  report.triangles = subject.mesh.triangles.size();
  context.report(0, "checking the mesh");
  FaceMatching matching;
  report.faults = findFaults(subject.mesh, &matching);
  report.isValid = report.faults.none() && (!subject.prisms || subject.prisms->faults.empty());
  report.prisms = subject.prisms ? std::optional(*subject.prisms) : std::nullopt;
  report.isMeasured = !report.faults.indicesOutOfRange && !report.faults.pointsNotFinite;
  CellMeasures own;
  CellMeasures& measures = cells ? *cells : own;
  measures = {};
  if (report.isMeasured && !context.stopped())
  {
    measureMesh(subject, matching, context, measures, report);
  }
  context.report(1, "checking the mesh");
  return report;
}
} // namespace ransmesh

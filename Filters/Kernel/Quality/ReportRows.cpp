#include "Quality/ReportRows.h"

#include <cstdio>

namespace ransmesh
{
namespace
{
class RowWriter
{
public:
  explicit RowWriter(std::vector<ReportRow>& rows)
    : rows_(rows)
  {
  }
  void scope(const std::string& name) { scope_ = name; }
  void add(const std::string& quantity, double value, const char* unit)
  {
    rows_.push_back({ quantity, value, unit, scope_ });
  }
  void add(const std::string& quantity, std::size_t value, const char* unit)
  {
    add(quantity, static_cast<double>(value), unit);
  }
  void add(const std::string& quantity, const Quantiles& q, const char* unit)
  {
    if (q.count == 0)
    {
      return;
    }
    for (std::size_t i = 0; i < Quantiles::Percents.size(); ++i)
    {
      add(quantity + " " + percentName(Quantiles::Percents[i]), q.at[i], unit);
    }
    add(quantity + " mean", q.mean, unit);
  }

private:
  std::vector<ReportRow>& rows_;
  std::string scope_ = "whole";
};

void addShapes(const ShapeSummary& shapes, RowWriter& rows)
{
  rows.add("TetrahedraMeasured", shapes.count, "tetrahedra");
  rows.add("LargestDihedral", shapes.largestDihedral, "degrees");
  rows.add("SmallestDihedral", shapes.smallestDihedral, "degrees");
  for (std::size_t i = 0; i < ShapeSummary::Limits.size(); ++i)
  {
    char name[48];
    std::snprintf(name, sizeof name, "ShareWithDihedralOver %g", ShapeSummary::Limits[i]);
    rows.add(name, shapes.shareOver[i], "1");
  }
  rows.add("Stretching", shapes.stretching, "1");
  rows.add("Quality", shapes.quality, "1");
}

void addWall(const WallSummary& wall, RowWriter& rows)
{
  if (wall.patch != 0)
  {
    rows.add("FirstHeightAsked", wall.asked.firstHeight, "length");
    rows.add("GrowthAsked", wall.asked.growthRate, "1");
    rows.add("LayersAsked", static_cast<std::size_t>(wall.asked.numberOfLayers), "layers");
  }
  rows.add("WallFaces", wall.faces, "triangles");
  rows.add("WallArea", wall.area, "length^2");
  rows.add("FirstHeight", wall.firstHeight, "length");
  rows.add("FirstHeightAchievedOverAsked", wall.firstHeightRatio, "1");
  rows.add("ShareOfAreaWithFirstHeight", wall.areaShareWithFirstHeight, "1");
  rows.add("WallPoints", wall.points, "points");
  rows.add("SmoothWallPoints", wall.smoothPoints, "points");
  rows.add("MeanLayers", wall.meanLayers, "layers");
  rows.add("ShareOfColumnsFull", wall.shareFull, "1");
  rows.add("ShareOfColumnsEmpty", wall.shareEmpty, "1");
  rows.add("GrowthAchieved", wall.growth, "1");
  rows.add("ColumnLean", wall.lean, "degrees");
  rows.add("Transition", wall.transition, "1");
  rows.add("LastSpacingOverWallEdge", wall.topToWallEdge, "1");
}
} // namespace

std::string percentName(double percent)
{
  char name[16];
  std::snprintf(name, sizeof name, "p%g", percent);
  return name;
}

std::vector<NamedFault> namedFaults(const MeshFaults& faults)
{
  return { { "IndicesOutOfRange", faults.indicesOutOfRange }, { "PointsNotFinite", faults.pointsNotFinite },
    { "PointsCoincident", faults.pointsCoincident }, { "PointsUnused", faults.pointsUnused },
    { "TetrahedraNotPositive", faults.tetsNotPositive },
    { "FacesInMoreThanTwoTetrahedra", faults.facesInMoreThanTwoTets },
    { "BoundaryFacesWithoutTriangle", faults.facesWithoutTriangle },
    { "TrianglesOffTheBoundary", faults.trianglesOffTheBoundary },
    { "RepeatedTriangles", faults.repeatedTriangles },
    { "TrianglesTurnedInward", faults.trianglesTurnedInward } };
}

std::vector<ReportRow> reportRows(const QualityReport& report)
{
  std::vector<ReportRow> out;
  RowWriter rows(out);
  rows.add("Valid", report.isValid ? 1.0 : 0.0, "1");
  for (const NamedFault& fault : namedFaults(report.faults))
  {
    rows.add(fault.name, fault.count, "faults");
  }
  if (report.prisms)
  {
    rows.add("Pyramids", report.prisms->pyramids, "cells");
    rows.add("Wedges", report.prisms->wedges, "cells");
    rows.add("Hexahedra", report.prisms->hexahedra, "cells");
    rows.add("ShareOfLayersInWedges", report.prisms->shareOfLayers, "1");
  }
  rows.add("Points", report.points, "points");
  rows.add("Tetrahedra", report.tetrahedra, "tetrahedra");
  rows.add("BoundaryTriangles", report.triangles, "triangles");
  if (!report.isMeasured)
  {
    return out;
  }
  rows.add("Volume", report.volume, "length^3");
  rows.add("CellVolume", report.cellVolume, "length^3");
  rows.add("LongestEdge", report.longestEdge, "length");
  rows.add("ShortestEdge", report.shortestEdge, "length");
  addShapes(report.all, rows);
  if (report.layers.count > 0)
  {
    rows.scope("layers");
    addShapes(report.layers, rows);
  }
  for (const PatchSummary& patch : report.patches)
  {
    rows.scope(patch.name);
    rows.add("BoundaryTriangles", patch.triangles, "triangles");
    rows.add("Area", patch.area, "length^2");
  }
  for (const RegionSummary& region : report.regions)
  {
    rows.scope("region " + region.name);
    rows.add("Tetrahedra", region.tetrahedra, "tetrahedra");
    rows.add("Volume", region.volume, "length^3");
  }
  rows.scope("whole");
  for (const StopCount& stop : report.stops)
  {
    rows.add("ColumnsStopped " + stop.reason, stop.columns, "columns");
  }
  for (const WallSummary& wall : report.walls)
  {
    rows.scope(wall.name);
    addWall(wall, rows);
  }
  return out;
}
} // namespace ransmesh

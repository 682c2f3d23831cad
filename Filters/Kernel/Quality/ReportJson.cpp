#include "Quality/ReportJson.h"

#include "Quality/JsonWriter.h"
#include "Quality/ReportRows.h"

namespace ransmesh
{
namespace
{
void write(JsonWriter& json, const char* name, const Quantiles& q)
{
  json.name(name).beginObject();
  if (q.count > 0)
  {
    for (std::size_t i = 0; i < Quantiles::Percents.size(); ++i)
    {
      json.name(percentName(Quantiles::Percents[i])).value(q.at[i]);
    }
    json.name("mean").value(q.mean);
  }
  json.name("count").value(q.count);
  json.endObject();
}

template <class Number>
void write(JsonWriter& json, const char* name, const std::vector<Number>& numbers)
{
  json.name(name).beginArray();
  for (const Number number : numbers)
  {
    json.value(number);
  }
  json.endArray();
}

void write(JsonWriter& json, const char* name, const ShapeSummary& shapes)
{
  json.name(name).beginObject();
  json.name("Tetrahedra").value(shapes.count);
  write(json, "LargestDihedral", shapes.largestDihedral);
  write(json, "SmallestDihedral", shapes.smallestDihedral);
  json.name("ShareWithDihedralOver").beginObject();
  for (std::size_t i = 0; i < ShapeSummary::Limits.size(); ++i)
  {
    json.name(percentName(ShapeSummary::Limits[i]).substr(1)).value(shapes.shareOver[i]);
  }
  json.endObject();
  write(json, "Stretching", shapes.stretching);
  write(json, "Quality", shapes.quality);
  json.endObject();
}

void write(JsonWriter& json, const PatchSummary& patch)
{
  json.beginObject();
  json.name("PatchId").value(patch.number);
  json.name("Name").value(patch.name);
  json.name("Type").value(nameOf(patch.type));
  json.name("IsSheet").value(patch.isSheet);
  json.name("Triangles").value(patch.triangles);
  json.name("Area").value(patch.area);
  json.endObject();
}

void write(JsonWriter& json, const RegionSummary& region)
{
  json.beginObject();
  json.name("RegionId").value(region.number);
  json.name("Name").value(region.name);
  json.name("Tetrahedra").value(region.tetrahedra);
  json.name("Volume").value(region.volume);
  json.endObject();
}

void writeAsked(JsonWriter& json, const LayerSpecification& asked)
{
  json.name("FirstHeightAsked").value(asked.firstHeight);
  json.name("GrowthAsked").value(asked.growthRate);
  json.name("LayersAsked").value(asked.numberOfLayers);
  json.name("ConstantLayersAsked").value(asked.constantLayers);
}

void write(JsonWriter& json, const WallSummary& wall)
{
  json.beginObject();
  json.name("PatchId").value(wall.patch);
  json.name("Name").value(wall.name);
  if (wall.patch != 0)
  {
    writeAsked(json, wall.asked);
  }
  json.name("WallFaces").value(wall.faces);
  json.name("WallArea").value(wall.area);
  json.name("ShareOfAreaWithFirstHeight").value(wall.areaShareWithFirstHeight);
  json.name("WallPoints").value(wall.points);
  json.name("SmoothWallPoints").value(wall.smoothPoints);
  json.name("MeanLayers").value(wall.meanLayers);
  json.name("ShareOfColumnsFull").value(wall.shareFull);
  json.name("ShareOfColumnsEmpty").value(wall.shareEmpty);
  write(json, "ColumnsByLayers", wall.columnsByLayers);
  write(json, "FirstHeight", wall.firstHeight);
  write(json, "FirstHeightAchievedOverAsked", wall.firstHeightRatio);
  write(json, "GrowthAchieved", wall.growth);
  write(json, "ColumnLean", wall.lean);
  write(json, "Transition", wall.transition);
  write(json, "LastSpacingOverWallEdge", wall.topToWallEdge);
  json.endObject();
}

void write(JsonWriter& json, const Histogram& histogram)
{
  json.beginObject();
  json.name("Quantity").value(histogram.quantity);
  json.name("Scope").value(histogram.scope);
  json.name("Counts").value(histogram.unit);
  write(json, "Low", histogram.low);
  write(json, "High", histogram.high);
  write(json, "Count", histogram.count);
  json.endObject();
}

// Objects by name, so that a script finds them without a search: rows that are objects have no array.
template <class Rows, class NameOf>
void writeByName(JsonWriter& json, const char* name, const Rows& rows, NameOf rowName)
{
  json.name(name).beginObject();
  for (const auto& row : rows)
  {
    json.name(rowName(row));
    write(json, row);
  }
  json.endObject();
}

void writePrisms(JsonWriter& json, const std::optional<PrismSummary>& prisms)
{
  if (!prisms)
  {
    return;
  }
  json.name("Prisms").beginObject();
  json.name("Tetrahedra").value(prisms->tetrahedra);
  json.name("Pyramids").value(prisms->pyramids);
  json.name("Wedges").value(prisms->wedges);
  json.name("Hexahedra").value(prisms->hexahedra);
  json.name("BoundaryQuadrilaterals").value(prisms->quadrilaterals);
  json.name("ShareOfLayers").value(prisms->shareOfLayers);
  json.name("Faults").value(prisms->faults);
  json.endObject();
}

void writeFaults(JsonWriter& json, const MeshFaults& faults)
{
  json.name("Faults").beginObject();
  for (const NamedFault& fault : namedFaults(faults))
  {
    json.name(fault.name).value(fault.count);
  }
  json.endObject();
}

void writeMeasures(JsonWriter& json, const QualityReport& report)
{
  json.name("Volume").value(report.volume);
  writeByName(
    json, "Patches", report.patches, [](const PatchSummary& p) { return std::to_string(p.number); });
  writeByName(
    json, "Regions", report.regions, [](const RegionSummary& r) { return std::to_string(r.number); });
  write(json, "CellVolume", report.cellVolume);
  write(json, "LongestEdge", report.longestEdge);
  write(json, "ShortestEdge", report.shortestEdge);
  json.name("Shapes").beginObject();
  write(json, "whole", report.all);
  write(json, "layers", report.layers);
  json.endObject();
  writeByName(json, "Walls", report.walls,
    [](const WallSummary& w) { return w.patch == 0 ? std::string("whole") : std::to_string(w.patch); });
  json.name("ColumnsStopped").beginObject();
  for (const StopCount& stop : report.stops)
  {
    json.name(stop.reason).value(stop.columns);
  }
  json.endObject();
  writeByName(
    json, "Histograms", report.histograms, [](const Histogram& h) { return h.quantity + " of " + h.scope; });
}
} // namespace

std::string reportJson(const QualityReport& report)
{
  JsonWriter json;
  json.beginObject();
  json.name("Valid").value(report.isValid);
  writeFaults(json, report.faults);
  writePrisms(json, report.prisms);
  json.name("Points").value(report.points);
  json.name("Tetrahedra").value(report.tetrahedra);
  json.name("BoundaryTriangles").value(report.triangles);
  if (report.isMeasured)
  {
    writeMeasures(json, report);
  }
  json.endObject();
  return json.text() + "\n";
}
} // namespace ransmesh

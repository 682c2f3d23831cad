#include "Quality/JsonWriter.h"
#include "Quality/ReportJson.h"
#include "Quality/ReportRows.h"
#include "Quality/ReportText.h"

#include "Support/LayeredBox.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace
{
using namespace ransmesh;

QualityReport goodReport()
{
  const MeshData mesh = layered_box::make(6, 6, 0.25, layered_box::levels(1e-3, 1.2, 10, 0.5));
  LayerPlan plan(layered_box::patches().size());
  plan[layered_box::Floor] = { 1e-3, 1.2, 10 };
  return reportQuality({ mesh, layered_box::patches(), plan }, {}, {});
}

QualityReport badReport()
{
  MeshData mesh = layered_box::make(2, 2, 0.25, { 0, 0.2 });
  mesh.points[3].x = INFINITY;
  return reportQuality({ mesh, layered_box::patches(), {} }, {}, {});
}

double valueOf(const std::vector<ReportRow>& rows, const std::string& quantity, const std::string& scope)
{
  const auto row = std::find_if(
    rows.begin(), rows.end(), [&](const ReportRow& r) { return r.quantity == quantity && r.scope == scope; });
  return row == rows.end() ? NAN : row->value;
}

TEST(ReportText, fitsOneScreen)
{
  std::istringstream text(reportText(goodReport()));
  int lines = 0;
  for (std::string line; std::getline(text, line); ++lines)
  {
    EXPECT_LE(line.size(), 100u) << line;
  }
  EXPECT_LE(lines, 50);
}

TEST(ReportText, saysWhatMatters)
{
  const std::string text = reportText(goodReport());
  for (const char* phrase :
    { "VALID", "floor", "symmetry", "dihedral", "degrees", "layers", "100 %", "growth" })
  {
    EXPECT_NE(text.find(phrase), std::string::npos) << phrase << "\n" << text;
  }
  EXPECT_EQ(text.find("INVALID"), std::string::npos);
}

TEST(ReportText, saysWhatIsWrong)
{
  const std::string text = reportText(badReport());
  EXPECT_NE(text.find("INVALID: 1 points not finite"), std::string::npos) << text;
}

TEST(ReportText, doesNotRoundToAllOrNone)
{
  QualityReport report = goodReport();
  report.all.shareOver[0] = 1e-9;
  report.walls[0].shareFull = report.walls[1].shareFull = 1 - 1e-9;
  const std::string text = reportText(report);
  EXPECT_NE(text.find("<0.001 %"), std::string::npos) << text;
  EXPECT_NE(text.find(">99.999 %"), std::string::npos) << text;
}

TEST(ReportRows, everyFigureHasARow)
{
  const auto rows = reportRows(goodReport());
  EXPECT_EQ(valueOf(rows, "Valid", "whole"), 1);
  EXPECT_EQ(valueOf(rows, "Tetrahedra", "whole"), 6 * 6 * 11 * 6);
  EXPECT_EQ(valueOf(rows, "ShareOfColumnsFull", "whole"), 1);
  EXPECT_EQ(valueOf(rows, "ShareOfColumnsFull", "floor"), 1);
  EXPECT_EQ(valueOf(rows, "LayersAsked", "floor"), 10);
  EXPECT_NEAR(valueOf(rows, "GrowthAchieved p50", "floor"), 1.2, 1e-9);
  EXPECT_LT(valueOf(rows, "LargestDihedral p100", "layers"), 91);
  EXPECT_NEAR(valueOf(rows, "Area", "lid"), 2.25, 1e-12);
  EXPECT_EQ(valueOf(rows, "ShareWithDihedralOver 179.9", "whole"), 0);
}

TEST(ReportRows, invalidMeshesHaveTheirFaults)
{
  const auto rows = reportRows(badReport());
  EXPECT_EQ(valueOf(rows, "Valid", "whole"), 0);
  EXPECT_EQ(valueOf(rows, "PointsNotFinite", "whole"), 1);
}

TEST(ReportJson, holdsTheFigures)
{
  const std::string text = reportJson(goodReport());
  for (const char* phrase : { "\"Valid\": true", "\"Tetrahedra\": 2376", "\"Name\": \"floor\"",
         "\"ShareOfColumnsFull\": 1", "\"LayersPerColumn of floor\"", "\"p99.9\"" })
  {
    EXPECT_NE(text.find(phrase), std::string::npos) << phrase << "\n" << text;
  }
  EXPECT_EQ(std::count(text.begin(), text.end(), '{'), std::count(text.begin(), text.end(), '}'));
  EXPECT_EQ(std::count(text.begin(), text.end(), '['), std::count(text.begin(), text.end(), ']'));
  EXPECT_NE(reportJson(badReport()).find("\"Valid\": false"), std::string::npos);
}

TEST(JsonWriter, writesValuesAndEscapes)
{
  JsonWriter json;
  json.beginObject();
  json.name("a \"name\"").value("back\\slash\n");
  json.name("list").beginArray();
  json.value(1);
  json.value(0.1);
  json.value(NAN);
  json.endArray();
  json.name("empty").beginObject();
  json.endObject();
  json.name("yes").value(true);
  json.endObject();
  EXPECT_EQ(json.text(),
    "{\n \"a \\\"name\\\"\": \"back\\\\slash\\u000a\",\n \"list\": [1, 0.1, null],\n \"empty\": {},\n "
    "\"yes\": true\n}");
}
} // namespace

// What the report says of sheets.
#include "Boundary/Sheets.h"
#include "Insertion/EnrichedSheets.h"
#include "Insertion/EnrichmentChecks.h"
#include "Layers/LayerPlanning.h"
#include "Quality/QualityReport.h"
#include "Quality/ReportJson.h"
#include "Quality/ReportText.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace ransmesh;

class SheetReport : public testing::Test
{
protected:
  void SetUp() override
  {
    patches_[7] = { "sheet", PatchType::Wake };
    grid_mesh::addSheet(mesh_, [](const Vector3& p) { return std::fabs(p.z - 0.5) < 1e-9; });
  }

  QualityReport report(const MeshData& mesh) const
  {
    return reportQuality({ mesh, patches_, plan_ }, {}, {});
  }

  MeshData mesh_ = grid_mesh::make({ 6, 6, 6 });
  PatchTable patches_ = grid_mesh::patches(PatchType::FarField, 7);
  LayerPlan plan_ = enrichment_checks::planFor(8, { 7 }, 1e-4, 6);
};

TEST_F(SheetReport, AMeshWithoutLayersHasThemOnNoSide)
{
  const QualityReport found = report(mesh_);
  EXPECT_TRUE(found.isValid);
  ASSERT_EQ(found.walls.size(), 2u);
  EXPECT_EQ(found.walls[1].points, 2u * 49u);
  EXPECT_EQ(found.walls[1].faces, 2u * 72u);
  EXPECT_NEAR(found.walls[1].area, 2, 1e-12);
  EXPECT_EQ(found.walls[1].shareFull, 0);
}

TEST_F(SheetReport, BothSidesAreFollowed)
{
  MeshData mesh = mesh_;
  OpenedSheets opened;
  EnrichedMesh enriched;
  ASSERT_TRUE(openSheets(mesh, opened).ok());
  ASSERT_TRUE(enrich(mesh, patchesOfOpened(patches_, opened.patches, plan_), plan_, {}, {}, enriched).ok());
  ASSERT_TRUE(closeSheets(opened, enriched).ok());
  const QualityReport found = report(enriched.mesh);
  EXPECT_TRUE(found.isValid) << found.faults.text();
  EXPECT_EQ(found.walls[1].smoothPoints, 2u * 49u);
  EXPECT_EQ(found.walls[1].shareFull, 1);
  EXPECT_EQ(found.walls[1].areaShareWithFirstHeight, 1);
  EXPECT_EQ(found.layers.count, enriched.report.layerTets);
  const PatchSummary& patch = found.patches.back();
  EXPECT_TRUE(patch.isSheet);
  EXPECT_EQ(patch.triangles, 72u);
  EXPECT_FALSE(found.patches.front().isSheet);
}

TEST_F(SheetReport, TextAndJsonSaySo)
{
  const QualityReport found = report(mesh_);
  EXPECT_NE(reportText(found).find("wake sheet"), std::string::npos);
  EXPECT_NE(reportText(found).find("sheets count with both sides"), std::string::npos);
  EXPECT_NE(reportJson(found).find("\"IsSheet\": true"), std::string::npos) << reportJson(found);
}
} // namespace

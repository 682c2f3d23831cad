// Where the front's tops stand, and what becomes of those that do not reach their height.
#include "Insertion/Front.h"
#include "Boundary/Sheets.h"
#include "Insertion/EnrichedOutput.h"
#include "Insertion/EnrichmentChecks.h"
#include "Insertion/FrontRaising.h"
#include "Layers/ColumnBuilder.h"
#include "Mesh/Builder.h"
#include "Support/GridMesh.h"

#include <algorithm>
#include <cmath>

using namespace enrichment_checks;
using namespace grid_mesh;

namespace
{
const Vector3 Foot{ 0.25, 0.5, 0 };

TetMesh meshOf(const MeshData& data)
{
  TetMesh mesh;
  EXPECT_TRUE(buildTetMesh(data, mesh).ok());
  return mesh;
}

// A floor with columns, of which one stands below the lower tip of a sheet that must not move.
struct BelowASheet
{
  TetMesh mesh;
  PatchTable table;
  ColumnSet set;

  BelowASheet(const LayerPlan& plan, double tip)
  {
    MeshData data = make({ 4, 4, 4 });
    const int sheet = addSheet(data,
      [](const Vector3& middle)
      {
        return std::fabs(middle.x - Foot.x) < 1e-9 && std::fabs(middle.y - Foot.y) < 0.25 &&
          middle.z > 0.25 && middle.z < 0.5;
      });
    OpenedSheets opened;
    EXPECT_TRUE(openSheets(data, opened).ok());
    std::find_if(data.points.begin(), data.points.end(),
      [](const Vector3& p) {
        return distance(p, { Foot.x, Foot.y, 0.25 }) < 1e-12;
      })
      ->z = tip;
    table = patches(PatchType::Symmetry, sheet);
    table.back().type = PatchType::Interface;
    EXPECT_TRUE(buildTetMesh(data, mesh).ok());
    set = buildColumns(mesh, BoundaryStars(mesh), table, plan);
  }
  RaisingReport raise()
  {
    RaisingReport report;
    EXPECT_TRUE(raiseFront(mesh, set, classify(mesh, table), 10, Context(), report));
    return report;
  }
  const Column& column() const
  {
    return *std::find_if(
      set.columns.begin(), set.columns.end(), [](const Column& c) { return distance(c.base, Foot) < 1e-12; });
  }
};

LayerPlan tenLayers()
{
  LayerPlan plan = planFor(8, { ZLow }, 0.02, 10);
  plan[ZLow].growthRate = 1;
  return plan;
}
} // namespace

TEST(Front, KnowsTheShortestEdgeAtEachColumn)
{
  const TetMesh mesh = meshOf(make({ 8, 2, 4 }));
  const ColumnSet set =
    buildColumns(mesh, BoundaryStars(mesh), patches(PatchType::Symmetry), planFor(8, { ZLow }, 0.01, 4));
  const Front front(mesh, set);
  ASSERT_FALSE(set.columns.empty());
  for (std::size_t c = 0; c < set.columns.size(); ++c)
  {
    EXPECT_DOUBLE_EQ(front.shortestEdge(static_cast<Index>(c)), 0.125);
    EXPECT_GT(set.columns[c].size, 0.2);
  }
}

TEST(Front, ATopThatIsLiftedAlreadyHasThatShareOfItsHeight)
{
  TetMesh mesh;
  ASSERT_TRUE(buildTetMesh(make({ 4, 4, 4 }), mesh).ok());
  ColumnSet set = buildColumns(mesh, BoundaryStars(mesh), patches(PatchType::Symmetry), tenLayers());
  set.columns[3].lifted = 0.05;
  const Front front(mesh, set);
  EXPECT_DOUBLE_EQ(front.share(3), 0.25);
  EXPECT_EQ(front.share(2), 0);
}

// The tip stands in the last spacing, so high as a share of it.
struct StuckTop
{
  BelowASheet floor;
  double share; // of the last spacing that the top has

  explicit StuckTop(double tip)
    : floor(growing(), heightAt(9 + tip))
  {
    EXPECT_EQ(floor.raise().stuck, 1U);
    share = (floor.mesh.point(floor.column().vertex).z - heightAt(9)) / (heightAt(10) - heightAt(9));
  }
  static LayerPlan growing()
  {
    LayerPlan plan = planFor(8, { ZLow }, 0.004, 10);
    plan[ZLow].growthRate = 1.3;
    return plan;
  }
  static double heightAt(double level)
  {
    const LayerHeights heights(growing()[ZLow]);
    const int below = static_cast<int>(level);
    return heights.height(below) + (level - below) * heights.spacing(below + 1);
  }
};

TEST(Front, ATopThatHasHalfOfItsLastSpacingIsLoweredByALevel)
{
  const StuckTop top(0.5);
  EXPECT_EQ(top.floor.column().levels, 9);
  EXPECT_EQ(top.floor.column().reason, StopReason::Refused);
  EXPECT_EQ(top.share, 0);
}

TEST(Front, ATopThatHasMostOfItsLastSpacingKeepsTheLevel)
{
  const StuckTop top(0.95);
  EXPECT_EQ(top.floor.column().levels, 10);
  EXPECT_GT(top.share, 0.8);
  EXPECT_LT(top.share, 0.95);
}

TEST(Front, AFirstHeightIsReportedAsItIs)
{
  LayerPlan plan = planFor(7, { ZLow }, 0.02, 1);
  TetMesh mesh;
  ASSERT_TRUE(buildTetMesh(make({ 4, 4, 4 }), mesh).ok());
  const ColumnSet set = buildColumns(mesh, BoundaryStars(mesh), patches(PatchType::Symmetry), plan);
  for (const Column& c : set.columns)
  {
    mesh.movePoint(c.vertex, set.pointAt(c, 1));
  }
  const Column& low = set.columns[12];
  mesh.movePoint(low.vertex, set.pointAtHeight(low, 0.017));
  EnrichedMesh enriched;
  writeEnriched(mesh, set, 10, enriched);
  for (const WallPoint& point : enriched.wallPoints)
  {
    EXPECT_NEAR(point.firstHeightAchieved, enriched.origin[point.point] == low.root ? 0.017 : 0.02, 1e-15);
  }
}

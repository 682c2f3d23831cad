#include "Quality/QualityReport.h"

#include "Support/LayeredBox.h"

#include <gtest/gtest.h>

namespace
{
using namespace ransmesh;

constexpr double firstHeight = 1e-3;
constexpr double growth = 1.2;
constexpr int layers = 10;
constexpr double cube = 0.25;

LayerPlan planOf(int number = layers, double height = firstHeight)
{
  LayerPlan plan(layered_box::patches().size());
  plan[layered_box::Floor].firstHeight = height;
  plan[layered_box::Floor].growthRate = growth;
  plan[layered_box::Floor].numberOfLayers = number;
  return plan;
}

MeshData goodMesh()
{
  return layered_box::make(8, 6, cube, layered_box::levels(firstHeight, growth, layers, 0.5));
}

QualityReport reportOf(const MeshData& mesh, const LayerPlan& plan, const std::vector<int>* layerId = nullptr)
{
  return reportQuality({ mesh, layered_box::patches(), plan, layerId }, {}, {});
}

TEST(QualityReport, countsAndSizes)
{
  const MeshData mesh = goodMesh();
  const QualityReport report = reportOf(mesh, {});
  EXPECT_TRUE(report.isValid) << report.faults.text();
  EXPECT_EQ(report.points, 9u * 7 * 12);
  EXPECT_EQ(report.tetrahedra, 8u * 6 * 11 * 6);
  EXPECT_EQ(report.triangles, 2u * (2 * 8 * 6 + 2 * 8 * 11 + 2 * 6 * 11));
  EXPECT_NEAR(report.volume, 8 * 6 * cube * cube * 0.5, 1e-12);
  ASSERT_EQ(report.patches.size(), 6u);
  EXPECT_EQ(report.patches[0].name, "floor");
  EXPECT_EQ(report.patches[0].triangles, 96u);
  EXPECT_NEAR(report.patches[0].area, 8 * 6 * cube * cube, 1e-12);
  EXPECT_TRUE(report.walls.empty());
  EXPECT_EQ(report.layers.count, 0u);
  EXPECT_NEAR(
    report.longestEdge.highest(), std::sqrt(2 * cube * cube + std::pow(0.5 - 1e-3 * 25.958682, 2)), 1e-6);
  EXPECT_NEAR(report.shortestEdge.lowest(), firstHeight, 1e-15);
}

TEST(QualityReport, completeLayersAreFoundComplete)
{
  const QualityReport report = reportOf(goodMesh(), planOf());
  ASSERT_EQ(report.walls.size(), 2u); // all walls, and the floor
  for (const WallSummary& wall : report.walls)
  {
    EXPECT_EQ(wall.faces, 96u);
    EXPECT_EQ(wall.points, 63u);
    EXPECT_EQ(wall.smoothPoints, 63u);
    EXPECT_DOUBLE_EQ(wall.meanLayers, layers);
    EXPECT_DOUBLE_EQ(wall.shareFull, 1);
    EXPECT_DOUBLE_EQ(wall.shareEmpty, 0);
    EXPECT_NEAR(wall.areaShareWithFirstHeight, 1, 1e-12);
    EXPECT_NEAR(wall.firstHeight.median(), firstHeight, 1e-12);
    EXPECT_NEAR(wall.firstHeightRatio.highest(), 1, 1e-9);
    EXPECT_NEAR(wall.growth.lowest(), growth, 1e-9);
    EXPECT_NEAR(wall.growth.highest(), growth, 1e-9);
    EXPECT_LT(wall.lean.highest(), 1e-6);
    ASSERT_EQ(wall.columnsByLayers.size(), layers + 1u);
    EXPECT_EQ(wall.columnsByLayers.back(), 63u);
  }
  EXPECT_EQ(report.walls[0].name, "whole");
  EXPECT_EQ(report.walls[1].name, "floor");
}

TEST(QualityReport, transitionComparesTheEdgeBeyondTheTopWithTheLastSpacing)
{
  const auto z = layered_box::levels(firstHeight, growth, layers, 0.5);
  const QualityReport report = reportOf(goodMesh(), planOf());
  const double last = z[layers] - z[layers - 1];
  EXPECT_NEAR(report.walls[0].transition.median(), (0.5 - z[layers]) / last, 1e-6);
  EXPECT_NEAR(report.walls[0].topToWallEdge.lowest(), last / 0.3, 0.2 * last / 0.3);
}

TEST(QualityReport, shortColumnsAreCountedByTheirLayers)
{
  const QualityReport report = reportOf(goodMesh(), planOf(layers + 2));
  EXPECT_DOUBLE_EQ(report.walls[1].shareFull, 0);
  EXPECT_DOUBLE_EQ(report.walls[1].meanLayers, layers);
  EXPECT_EQ(report.walls[1].columnsByLayers[layers], 63u);
}

TEST(QualityReport, missingLayersAndWrongFirstHeightShow)
{
  const QualityReport report = reportOf(goodMesh(), planOf(layers, 2 * firstHeight));
  EXPECT_DOUBLE_EQ(report.walls[0].shareEmpty, 1);
  EXPECT_DOUBLE_EQ(report.walls[0].areaShareWithFirstHeight, 0);
  EXPECT_NEAR(report.walls[0].firstHeightRatio.median(), 0.5, 1e-9);
  EXPECT_EQ(report.walls[0].growth.count, 0u);
}

TEST(QualityReport, wallsWithLayersOfTheirOwnAreToldApart)
{
  MeshData mesh = goodMesh();
  PatchTable patches = layered_box::patches();
  patches.push_back({ "floor2", PatchType::Wall });
  LayerPlan plan = planOf();
  plan.push_back(plan[layered_box::Floor]);
  plan.back().numberOfLayers = 2 * layers;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const auto& v = mesh.triangles[i];
    const double x = (mesh.points[v[0]].x + mesh.points[v[1]].x + mesh.points[v[2]].x) / 3;
    mesh.trianglePatch[i] = mesh.trianglePatch[i] == layered_box::Floor && x > 1 ? 7 : mesh.trianglePatch[i];
  }
  const QualityReport report = reportQuality({ mesh, patches, plan, nullptr }, {}, {});
  ASSERT_EQ(report.walls.size(), 3u);
  EXPECT_EQ(report.walls[1].points + report.walls[2].points, report.walls[0].points);
  EXPECT_DOUBLE_EQ(report.walls[1].shareFull, 1);
  EXPECT_DOUBLE_EQ(report.walls[2].shareFull, 0);
  EXPECT_EQ(report.walls[2].name, "floor2");
  EXPECT_NEAR(report.walls[0].shareFull, 35.0 / 63, 1e-12); // points on the seam belong to the lower number
}

TEST(QualityReport, tetrahedraInLayersAreFoundOrRead)
{
  const MeshData mesh = goodMesh();
  EXPECT_EQ(reportOf(mesh, planOf()).layers.count, 8u * 6 * layers * 6);
  std::vector<int> layerId(mesh.tetrahedra.size(), 0);
  layerId[3] = layerId[5] = 1;
  EXPECT_EQ(reportOf(mesh, planOf(), &layerId).layers.count, 2u);
  EXPECT_EQ(reportOf(mesh, {}, &layerId).layers.count, 2u);
}

TEST(QualityReport, anglesOfLayersKeepTheirSharesAndQuantiles)
{
  const QualityReport report = reportOf(goodMesh(), planOf());
  EXPECT_LT(report.layers.largestDihedral.highest(), 91); // Kuhn's tetrahedra on right-angled triangles
  EXPECT_DOUBLE_EQ(report.layers.shareOver[0], 0);
  EXPECT_GT(report.layers.stretching.highest(), cube / firstHeight);
}

TEST(QualityReport, layersOfExtremeThinness)
{
  const MeshData mesh = layered_box::make(4, 4, cube, layered_box::levels(1e-8, growth, 25, 0.5));
  const QualityReport report = reportOf(mesh, planOf(25, 1e-8));
  EXPECT_TRUE(report.isValid);
  EXPECT_DOUBLE_EQ(report.walls[0].shareFull, 1);
  EXPECT_NEAR(report.walls[0].areaShareWithFirstHeight, 1, 1e-12);
  EXPECT_NEAR(report.walls[0].growth.highest(), growth, 1e-6);
}

TEST(QualityReport, anInvalidMeshIsReported)
{
  MeshData mesh = goodMesh();
  std::swap(mesh.tetrahedra[7][0], mesh.tetrahedra[7][1]);
  mesh.triangles.pop_back();
  mesh.trianglePatch.pop_back();
  const QualityReport report = reportOf(mesh, planOf());
  EXPECT_FALSE(report.isValid);
  EXPECT_TRUE(report.isMeasured);
  EXPECT_EQ(report.faults.tetsNotPositive, 1u);
  EXPECT_EQ(report.faults.facesWithoutTriangle, 1u);
}

TEST(QualityReport, whatCannotBeMeasuredIsNot)
{
  MeshData outOfRange = goodMesh();
  outOfRange.tetrahedra[7][2] = 1000000;
  EXPECT_FALSE(reportOf(outOfRange, planOf()).isMeasured);
  MeshData notFinite = goodMesh();
  notFinite.points[11].y = NAN;
  CellMeasures cells;
  const QualityReport report = reportQuality({ notFinite, layered_box::patches(), planOf() }, {}, {}, &cells);
  EXPECT_FALSE(report.isValid);
  EXPECT_FALSE(report.isMeasured);
  EXPECT_EQ(report.faults.pointsNotFinite, 1u);
  EXPECT_EQ(cells.count(), 0u);
}

TEST(QualityReport, survivesCoordinatesThatOverflow)
{
  for (const double scale : { 1e100, 1e200, 1e-120 })
  {
    MeshData mesh = goodMesh();
    for (Vector3& p : mesh.points)
    {
      p = scale * p;
    }
    const QualityReport report = reportOf(mesh, planOf(layers, scale * firstHeight));
    EXPECT_EQ(report.faults.facesInMoreThanTwoTets, 0u);
    EXPECT_TRUE(report.isMeasured);
  }
}

TEST(QualityReport, stopsOnRequest)
{
  Context context;
  context.cancelled = [] { return true; };
  const QualityReport report = reportQuality({ goodMesh(), layered_box::patches(), planOf() }, {}, context);
  EXPECT_FALSE(report.all.count > 0);
}

TEST(Distribution, quantilesInterpolateBetweenNeighbours)
{
  std::vector<double> values;
  for (int i = 100; i >= 0; --i)
  {
    values.push_back(i);
  }
  const Quantiles q = quantilesOf(values);
  EXPECT_DOUBLE_EQ(q.lowest(), 0);
  EXPECT_DOUBLE_EQ(q.at[1], 1);
  EXPECT_DOUBLE_EQ(q.at[2], 5);
  EXPECT_DOUBLE_EQ(q.median(), 50);
  EXPECT_DOUBLE_EQ(q.at[4], 95);
  EXPECT_NEAR(q.at[6], 99.9, 1e-12);
  EXPECT_DOUBLE_EQ(q.highest(), 100);
  EXPECT_DOUBLE_EQ(q.mean, 50);
  EXPECT_EQ(quantilesOf({}).count, 0u);
  EXPECT_EQ(quantilesOf({ NAN, NAN }).count, 0u);
  EXPECT_DOUBLE_EQ(quantilesOf({ 2, NAN, 4 }).mean, 3);
  EXPECT_DOUBLE_EQ(quantilesOf({ 3 }).at[6], 3);
  EXPECT_DOUBLE_EQ(quantilesOf({ 3, 4 }).median(), 3.5);
}

TEST(Distribution, histogramsCountEveryValueOnce)
{
  const Histogram even = evenHistogram({ -1, 0, 0.5, 1, 2, 7 }, 0, 2, 2);
  EXPECT_EQ(even.count, (std::vector<std::size_t>{ 3, 3 }));
  const Histogram decades = decadeHistogram({ 1, 5, 10, 99, 100, 999 }, 1);
  EXPECT_EQ(decades.count, (std::vector<std::size_t>{ 2, 2, 2 }));
  EXPECT_DOUBLE_EQ(decades.high.back(), 1000);
}
} // namespace

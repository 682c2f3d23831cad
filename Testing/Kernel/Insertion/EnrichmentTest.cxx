#include "Insertion/EnrichmentChecks.h"
#include "Mesh/Validation.h"
#include "Support/GridMesh.h"

#include <cmath>

using namespace enrichment_checks;
using namespace grid_mesh;

namespace
{
// No angle of a clean layer exceeds the larger of a right angle and the wall's own.
double largestWallAngle(const MeshData& mesh, int wall)
{
  double largest = 90;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    for (int j = 0; mesh.trianglePatch[i] == wall && j < 3; ++j)
    {
      const auto at = [&](int k) { return mesh.points[mesh.triangles[i][(j + k) % 3]]; };
      const Vector3 u = normalized(at(1) - at(0));
      const Vector3 v = normalized(at(2) - at(0));
      largest = std::max(largest, std::acos(dot(u, v)) * 180 / M_PI);
    }
  }
  return largest;
}

// That the points of all columns on a floor at z = 0 have their levels' heights.
void expectHeights(const EnrichedMesh& enriched, const LayerHeights& heights)
{
  std::map<Index, int> level;
  for (std::size_t i = 0; i < enriched.mesh.points.size(); ++i)
  {
    if (enriched.column[i] != None)
    {
      EXPECT_NEAR(enriched.mesh.points[i].z, heights.height(level[enriched.column[i]]++), 1e-12);
    }
  }
  EXPECT_FALSE(level.empty());
}

PatchTable plateTable()
{
  PatchTable table = patches(PatchType::Symmetry);
  table[ZLow].type = PatchType::Wall;
  return table;
}

// A quarter of a ring: the outer side (ZHigh) is a pipe's wall seen from inside, the inner (ZLow) a
// cylinder's seen from outside.
Vector3 ring(const Vector3& p)
{
  const double angle = M_PI / 2 * p.x;
  const double radius = 0.5 + 0.5 * p.z;
  return { radius * std::sin(angle), p.y, radius * std::cos(angle) };
}
} // namespace

TEST(Enrichment, PlateIsComplete)
{
  const MeshData mesh = make({ 6, 5, 4, {}, 0.2 });
  const auto enriched = enrichAndCheck(mesh, plateTable(), planFor(7, { ZLow }, 1e-5, 25));
  expectCompleteLayers(mesh, enriched, ZLow, 25);
  EXPECT_LT(largestLayerAngle(enriched), largestWallAngle(mesh, ZLow) + 0.01);
  EXPECT_EQ(enriched.report.layerTets, 25u * 3u * 60u);
}

TEST(Enrichment, PlateOfTinyFirstHeightTurnedToNoAxis)
{
  const MeshData mesh = make({ 6, 5, 4, turned, 0.2 });
  const auto enriched = enrichAndCheck(mesh, plateTable(), planFor(7, { ZLow }, 1e-8, 25));
  expectCompleteLayers(mesh, enriched, ZLow, 25);
  EXPECT_LT(largestLayerAngle(enriched), largestWallAngle(mesh, ZLow) + 0.01);
}

TEST(Enrichment, HeightsAreTheOnesAsked)
{
  const MeshData mesh = make({ 5, 5, 4 });
  const LayerPlan plan = planFor(7, { ZLow }, 1e-4, 12);
  const auto enriched = enrichAndCheck(mesh, plateTable(), plan);
  const LayerHeights heights(plan[ZLow]);
  for (const WallPoint& wall : enriched.wallPoints)
  {
    EXPECT_NEAR(wall.firstHeightAchieved, 1e-4, 1e-12);
    EXPECT_EQ(wall.firstHeightAsked, 1e-4);
  }
  expectHeights(enriched, heights);
}

TEST(Enrichment, ConstantFirstLayersDoNotGrow)
{
  LayerPlan plan = planFor(7, { ZLow }, 1e-3, 8);
  plan[ZLow].constantLayers = 3;
  const LayerHeights heights(plan[ZLow]);
  EXPECT_DOUBLE_EQ(heights.spacing(3), 1e-3);
  EXPECT_NEAR(heights.spacing(4), 1.2e-3, 1e-15);
  expectHeights(enrichAndCheck(make({ 5, 5, 4 }), plateTable(), plan), heights);
}

TEST(Enrichment, RingsInsideAndOutsideAreComplete)
{
  const MeshData mesh = make({ 10, 4, 5, ring });
  PatchTable table = patches(PatchType::Symmetry);
  for (const int wall : { ZLow, ZHigh })
  {
    const auto enriched = enrichAndCheck(mesh, table, planFor(7, { wall }, 1e-5, 25));
    expectCompleteLayers(mesh, enriched, wall, 25);
    EXPECT_LT(largestLayerAngle(enriched), 110);
  }
}

TEST(Enrichment, LayersThickerThanTheSurfaceSizeStayValid)
{
  const MeshData mesh = make({ 8, 8, 10, {}, 0.2 });
  const auto enriched = enrichAndCheck(mesh, plateTable(), planFor(7, { ZLow }, 1e-3, 20));
  EXPECT_GT(enriched.report.pointsInserted, 0.9 * static_cast<double>(enriched.report.pointsRequested));
  EXPECT_LT(largestLayerAngle(enriched), 175);
}

TEST(Enrichment, SixViscousWallsStayValid)
{
  const MeshData mesh = make({ 6, 6, 6 });
  const auto enriched = enrichAndCheck(
    mesh, patches(PatchType::Wall), planFor(7, { XLow, XHigh, YLow, YHigh, ZLow, ZHigh }, 1e-5, 20));
  EXPECT_EQ(enriched.report.pointsInserted, enriched.report.pointsRequested);
}

TEST(Enrichment, AWallThatEndsInAPlaneKeepsItsLastColumns)
{
  const int symmetryPart = 7;
  const auto split = [&](Side side, const Vector3& middle)
  { return side == ZLow && middle.x < 0.5 ? symmetryPart : static_cast<int>(side); };
  const MeshData mesh = make({ 6, 4, 4 }, split);
  PatchTable table = patches(PatchType::Symmetry, 7);
  table[ZLow].type = PatchType::Wall;
  const auto enriched = enrichAndCheck(mesh, table, planFor(8, { ZLow }, 1e-5, 10));
  EXPECT_EQ(enriched.report.columnsByReason[static_cast<int>(StopReason::Complete)], 4u * 5u);
}

TEST(Enrichment, WallsOfDifferentLayersMeet)
{
  const int second = 7;
  const auto split = [&](Side side, const Vector3& middle)
  { return side == ZLow && middle.x < 0.5 ? second : static_cast<int>(side); };
  const MeshData mesh = make({ 6, 4, 4 }, split);
  PatchTable table = patches(PatchType::Symmetry, 7);
  LayerPlan plan = planFor(8, { ZLow, second }, 1e-5, 10);
  plan[second].firstHeight = 1e-4;
  plan[second].growthRate = 1.3;
  plan[second].numberOfLayers = 6;
  const auto enriched = enrichAndCheck(mesh, table, plan);
  std::map<int, int> columns;
  for (const WallPoint& wall : enriched.wallPoints)
  {
    EXPECT_EQ(wall.layersAsked, wall.patch == second ? 6 : 10);
    EXPECT_EQ(wall.layersAchieved, wall.layersAsked);
    ++columns[wall.patch];
  }
  EXPECT_EQ(columns[second], 3 * 5); // the border takes the smaller first height
  EXPECT_EQ(columns[ZLow], 4 * 5);
}

// The columns on their common edge have one height, those beside it have the triangles' own.
TEST(Enrichment, TrianglesBesideAWallOfOtherHeightsHaveTheirOwn)
{
  const auto split = [](Side side, const Vector3& middle)
  { return side == ZLow && middle.y < 0.5 ? 7 : static_cast<int>(side); };
  for (const double ratio : { 0.2, 5.0 })
  {
    LayerPlan plan = planFor(8, { ZLow, 7 }, 1e-4, 10);
    plan[7].firstHeight = ratio * 1e-4;
    const auto enriched = enrichAndCheck(make({ 6, 6, 4 }, split), patches(PatchType::Symmetry, 7), plan);
    std::map<std::set<Index>, double> wanted; // by the wall's triangles
    for (std::size_t i = 0; i < enriched.mesh.triangles.size(); ++i)
    {
      const int patch = enriched.mesh.trianglePatch[i];
      if (plan[patch].hasLayers())
      {
        const auto& v = enriched.mesh.triangles[i];
        wanted[{ v.begin(), v.end() }] = plan[patch].firstHeight;
      }
    }
    std::size_t found = 0;
    for (const auto& v : enriched.mesh.tetrahedra)
    {
      for (std::size_t apex = 0; apex < 4; ++apex)
      {
        std::set<Index> others(v.begin(), v.end());
        others.erase(v[apex]);
        if (const auto at = wanted.find(others); at != wanted.end())
        {
          EXPECT_NEAR(enriched.mesh.points[v[apex]].z, at->second, 1e-6 * at->second);
          ++found;
        }
      }
    }
    EXPECT_EQ(found, wanted.size());
  }
}

TEST(Enrichment, AnInterfaceIsNotTouched)
{
  const MeshData mesh = make({ 5, 4, 4 });
  PatchTable table = plateTable();
  table[XLow].type = PatchType::Interface;
  const auto enriched = enrichAndCheck(mesh, table, planFor(7, { ZLow }, 1e-4, 10));
  std::set<std::array<double, 9>> before;
  std::set<std::array<double, 9>> after;
  const auto collect = [](const MeshData& m, std::set<std::array<double, 9>>& out)
  {
    for (std::size_t i = 0; i < m.triangles.size(); ++i)
    {
      if (m.trianglePatch[i] == XLow)
      {
        std::array<Vector3, 3> p = { m.points[m.triangles[i][0]], m.points[m.triangles[i][1]],
          m.points[m.triangles[i][2]] };
        std::sort(p.begin(), p.end(),
          [](const Vector3& a, const Vector3& b) {
            return std::array{ a.x, a.y, a.z } < std::array{ b.x, b.y, b.z };
          });
        out.insert({ p[0].x, p[0].y, p[0].z, p[1].x, p[1].y, p[1].z, p[2].x, p[2].y, p[2].z });
      }
    }
  };
  collect(mesh, before);
  collect(enriched.mesh, after);
  EXPECT_EQ(before, after);
  EXPECT_EQ(enriched.report.columnsByReason[static_cast<int>(StopReason::Frozen)], 5u);
}

TEST(Enrichment, ColumnsShareAGap)
{
  const double gap = 0.02;
  const MeshData mesh = make({ 6, 6, 2, [&](const Vector3& p) { return Vector3{ p.x, p.y, gap * p.z }; } });
  const LayerPlan plan = planFor(7, { ZLow, ZHigh }, 1e-4, 25);
  const LayerHeights heights(plan[ZLow]);
  for (const WallPoint& wall : enrichAndCheck(mesh, patches(PatchType::Symmetry), plan).wallPoints)
  {
    EXPECT_EQ(wall.reason, StopReason::Gap);
    EXPECT_GT(heights.height(wall.layersAchieved), 0.2 * gap);
    EXPECT_LE(heights.height(wall.layersAchieved), 0.3 * gap * (1 + 1e-9));
  }
}

TEST(Enrichment, StepsAreSmoothedBesideColumnsThatDisagree)
{
  // A side that becomes flat: from some point on columns stand on it, and where both kinds meet they are lost.
  const auto flattening = [](const Vector3& p) {
    return Vector3{ p.x - (1 - p.x) * p.z * 4 * p.y, p.y, p.z };
  };
  const MeshData mesh = make({ 8, 8, 8, flattening });
  LayerPlan plan = planFor(7, { ZLow }, 0.02, 8);
  plan[ZLow].growthRate = 1;
  const auto enriched = enrichAndCheck(mesh, plateTable(), plan, 1e-3); // the side is curved
  std::map<Index, int> levels;
  for (const WallPoint& point : enriched.wallPoints)
  {
    levels[enriched.origin[point.point]] = point.layersAchieved;
  }
  std::size_t lost = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (int j = 0; mesh.trianglePatch[t] == ZLow && j < 3; ++j)
    {
      const Index a = mesh.triangles[t][j];
      const Index b = mesh.triangles[t][(j + 1) % 3];
      if (levels.at(a) == 0 && mesh.points[a].y > 0.3) // elsewhere the bent side leaves no room
      {
        ++lost;
        EXPECT_LE(0.02 * levels.at(b), 0.7 * distance(mesh.points[a], mesh.points[b]) + 1e-12);
      }
    }
  }
  EXPECT_GT(lost, 0U);
}

TEST(Enrichment, WhatIsPoorBeyondTheFrontIsSwappedAway)
{
  const auto enriched =
    enrichAndCheck(make({ 8, 8, 8, turned, 0.25 }), plateTable(), planFor(7, { ZLow, XLow }, 5e-4, 22));
  EXPECT_GT(enriched.report.improvements, 0U);
}

TEST(Enrichment, IsTheSameTwice)
{
  const MeshData mesh = make({ 8, 8, 8, turned, 0.25 });
  const LayerPlan plan = planFor(7, { ZLow, XLow }, 5e-4, 22);
  const auto a = enrichAndCheck(mesh, plateTable(), plan);
  const auto b = enrichAndCheck(mesh, plateTable(), plan);
  EXPECT_EQ(a.mesh.points, b.mesh.points);
  EXPECT_EQ(a.mesh.tetrahedra, b.mesh.tetrahedra);
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
}

TEST(Enrichment, StopsOnRequest)
{
  Context context;
  context.cancelled = [] { return true; };
  EnrichedMesh enriched;
  const Outcome outcome =
    enrich(make({}), plateTable(), planFor(7, { ZLow }, 1e-5, 25), {}, context, enriched);
  EXPECT_EQ(outcome.kind, Outcome::Kind::Cancelled);
  EXPECT_TRUE(enriched.mesh.tetrahedra.empty());
}

TEST(Enrichment, RefusesAnInvalidMesh)
{
  MeshData mesh = make({});
  std::swap(mesh.tetrahedra[5][0], mesh.tetrahedra[5][1]);
  EnrichedMesh enriched;
  const Outcome outcome = enrich(mesh, plateTable(), planFor(7, { ZLow }, 1e-5, 25), {}, {}, enriched);
  EXPECT_EQ(outcome.kind, Outcome::Kind::BadInput);
  EXPECT_NE(outcome.message.find("1 tetrahedra not positive"), std::string::npos) << outcome.message;
}

TEST(Enrichment, RandomWallsAndLayersAreAlwaysValid)
{
  std::mt19937 random(20260101);
  const auto chance = [&random](double p) { return std::uniform_real_distribution<>(0, 1)(random) < p; };
  for (int run = 0; run < 40; ++run)
  {
    Grid grid;
    grid.nx = 3 + static_cast<int>(random() % 6);
    grid.ny = 3 + static_cast<int>(random() % 6);
    grid.nz = 3 + static_cast<int>(random() % 6);
    grid.jitter = 0.15;
    grid.seed = run;
    const double scale = std::pow(10, static_cast<int>(random() % 9) - 3);
    const bool turn = chance(0.5);
    grid.map = [=](const Vector3& p) { return scale * (turn ? turned(p) : p); };
    PatchTable table = patches(PatchType::Symmetry);
    std::set<int> walls;
    for (int side = 1; side <= 6; ++side)
    {
      if (chance(0.4))
      {
        walls.insert(side);
        table[side].type = PatchType::Wall;
      }
    }
    const double firstHeight = scale * std::pow(10, -2 - static_cast<int>(random() % 6));
    SCOPED_TRACE("run " + std::to_string(run));
    enrichAndCheck(make(grid), table, planFor(7, walls, firstHeight, 1 + static_cast<int>(random() % 30)));
  }
}

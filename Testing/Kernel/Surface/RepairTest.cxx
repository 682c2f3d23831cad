#include "Surface/Repair.h"
#include "Surface/Borders.h"
#include "Surface/Diagnosis.h"
#include "Surface/Folds.h"
#include "Surface/HoleFilling.h"
#include "Surface/ShortEdges.h"
#include "Surface/Welding.h"
#include "Surface/Wrapping.h"

#include "Support/RoundCube.h"

#include <gtest/gtest.h>

namespace
{
using namespace ransmesh;
using namespace ransmesh::test;

bool isSound(const SurfaceMesh& surface)
{
  return diagnose(surface, {}, {}).isSound();
}

SurfaceMesh withoutSide(const SurfaceMesh& surface, int patch)
{
  SurfaceMesh rest = surface;
  std::vector<char> stays;
  for (const int p : rest.patch)
  {
    stays.push_back(p != patch);
  }
  keepTriangles(rest, stays);
  mergeEqualPoints(rest);
  return rest;
}

double areaOf(const SurfaceMesh& surface)
{
  double area = 0;
  for (const SurfacePiece& piece : findPieces(surface))
  {
    area += piece.area;
  }
  return area;
}
} // namespace

TEST(Repair, LeavesASoundSurfaceAlone)
{
  SurfaceMesh surface = ball(4);
  PatchTable patches = sixPatches();
  EXPECT_TRUE(repairSurface(surface, patches, {}).empty());
  EXPECT_EQ(surface.triangles, ball(4).triangles);
}

TEST(Borders, RunAgainstWhatFillsThem)
{
  const auto borders = findBorders(withoutSide(cube(3), 4));
  ASSERT_EQ(borders.size(), 1u);
  EXPECT_TRUE(borders[0].isClosed);
  EXPECT_EQ(borders[0].points.size(), 12u);
  EXPECT_EQ(borders[0].extent.length(1), 0);
  EXPECT_EQ(borders[0].extent.length(2), 2);
}

TEST(Borders, AreTakenApartWhereTheyTouch)
{
  SurfaceMesh surface = cube(2); // two triangles with one common point go
  const Index v = surface.triangles[0][0];
  std::vector<char> stays(surface.triangles.size(), 1);
  stays[0] = 0;
  for (std::size_t t = 1; t < stays.size(); ++t)
  {
    const auto& c = surface.triangles[t];
    const auto& first = surface.triangles[0];
    int common = 0;
    for (const Index w : c)
    {
      common += std::count(first.begin(), first.end(), w) > 0;
    }
    if (common == 1 && std::count(c.begin(), c.end(), v) > 0)
    {
      stays[t] = 0;
      break;
    }
  }
  keepTriangles(surface, stays);
  const auto borders = findBorders(surface);
  ASSERT_EQ(borders.size(), 2u);
  EXPECT_EQ(borders[0].points.size(), 3u);
  EXPECT_EQ(borders[1].points.size(), 3u);
}

TEST(HoleFilling, ClosesAPlaneHoleWithoutChangingTheBody)
{
  SurfaceMesh surface = withoutSide(cube(4), 6);
  PatchTable patches = sixPatches();
  EXPECT_EQ(fillHoles(surface, patches, 1.9, {}).holes, 0u);
  EXPECT_EQ(fillHoles(surface, patches, 2, { { 2, 1, false } }).holes, 0u); // the plane z = 1 closes it
  const FillReport report = fillHoles(surface, patches, 2, {});
  EXPECT_EQ(report.holes, 1u);
  EXPECT_EQ(report.triangles, 14u);
  EXPECT_EQ(patches.back().name, "hole_1");
  EXPECT_TRUE(isSound(surface));
  EXPECT_EQ(diagnose(surface, {}, {}).count(SurfaceFault::Turned), 0u);
  EXPECT_NEAR(areaOf(surface), 24, 1e-12);
}

TEST(HoleFilling, GivesASmallHoleToThePatchAroundIt)
{
  SurfaceMesh surface = ball(4);
  surface.triangles.erase(surface.triangles.begin() + 40);
  surface.patch.erase(surface.patch.begin() + 40);
  PatchTable patches = sixPatches();
  EXPECT_EQ(fillHoles(surface, patches, 1, {}).newPatches, 0u);
  EXPECT_EQ(patches.size(), 7u);
  EXPECT_EQ(surface.patch.back(), 2);
  EXPECT_TRUE(isSound(surface));
}

TEST(Welding, KeepsPointsOfOneTriangleApart)
{
  SurfaceMesh surface = withoutSide(cube(4), 3);
  EXPECT_EQ(weldBorders(surface, 1).points, 0u); // edges are 0.5 long
  EXPECT_EQ(widthOfGaps(surface), 0);
}

TEST(Welding, ClosesAGap)
{
  SurfaceMesh surface = withoutSide(cube(4), 3);
  SurfaceMesh lid;
  const SurfaceMesh whole = cube(4);
  lid.points = moved(whole, { 0, -1e-3, 0 }).points;
  for (std::size_t t = 0; t < whole.triangles.size(); ++t)
  {
    if (whole.patch[t] == 3)
    {
      lid.triangles.push_back(whole.triangles[t]);
      lid.patch.push_back(3);
    }
  }
  append(surface, lid);
  mergeEqualPoints(surface);
  EXPECT_NEAR(widthOfGaps(surface), 1e-3, 1e-12);
  SurfaceMesh other = surface;
  EXPECT_EQ(weldBorders(other, 0.9e-3).points, 0u);
  const WeldReport report = weldBorders(surface, 1.1e-3);
  EXPECT_EQ(report.points, 16u);
  EXPECT_NEAR(report.farthest, 1e-3, 1e-12);
  EXPECT_TRUE(isSound(surface));
}

TEST(Folds, GoWhereTheyAreJoinedAlongTheirBorder)
{
  // A triangle that stands on an edge of the surface, given twice.
  SurfaceMesh surface = ball(4);
  const auto t = surface.triangles[10];
  surface.points.push_back(1.1 * surface.points[t[0]]);
  const auto tip = static_cast<Index>(surface.points.size()) - 1;
  surface.triangles.push_back({ t[0], t[1], tip });
  surface.triangles.push_back({ t[1], t[0], tip });
  surface.patch.insert(surface.patch.end(), 2, 1);
  SurfaceMesh large = surface;
  const DuplicateReport report = dropDuplicates(surface, 1);
  EXPECT_EQ(report.folded, 2u);
  EXPECT_EQ(report.dropped, 0u);
  EXPECT_TRUE(isSound(surface));
  EXPECT_EQ(dropDuplicates(large, 0.01).dropped, 1u); // too large to go unseen
  EXPECT_FALSE(isSound(large));
}

TEST(ShortEdges, AreCollapsed)
{
  SurfaceMesh surface = ball(4);
  // A point split in two that lie close to each other.
  const auto t = surface.triangles[7];
  const Vector3 place = surface.points[t[0]] + 1e-7 * (centreOf(surface, 7) - surface.points[t[0]]);
  const auto extra = static_cast<Index>(surface.points.size());
  surface.points.push_back(place);
  surface.triangles[7] = { t[0], t[1], extra };
  surface.triangles.push_back({ t[1], t[2], extra });
  surface.triangles.push_back({ t[2], t[0], extra });
  surface.patch.insert(surface.patch.end(), 2, surface.patch[7]);
  ASSERT_TRUE(isSound(surface));
  EXPECT_EQ(collapseShortEdges(surface, 1e-9).edges, 0u);
  EXPECT_EQ(collapseShortEdges(surface, 1e-6).edges, 1u);
  EXPECT_EQ(surface.triangles.size(), 192u);
  EXPECT_TRUE(isSound(surface));
}

TEST(ShortEdges, KeepPatchesAndTopology)
{
  SurfaceMesh surface = cube(4);
  collapseShortEdges(surface, 10); // as far as that goes
  EXPECT_EQ(diagnose(surface, {}, {}).count(SurfaceFault::OpenEdge), 0u);
  EXPECT_EQ(diagnose(surface, {}, {}).count(SurfaceFault::NonManifoldEdge), 0u);
  EXPECT_NEAR(areaOf(surface), 24, 1e-12); // sides stay plane, edges straight
  EXPECT_LT(surface.triangles.size(), 192u);
}

TEST(Wrapping, ClosesWhatIsOpenAndCrosses)
{
  SurfaceMesh surface = withoutSide(ball(4), 1);
  append(surface, moved(ball(4), { 0.9, 0.1, 0 }, 0.6));
  WrapReport report;
  ASSERT_TRUE(wrapSurface(surface, { 2.5, 0.05 }, {}, report).ok());
  EXPECT_EQ(report.offset, 0.05);
  EXPECT_TRUE(isSound(surface));
  EXPECT_EQ(report.triangles, surface.triangles.size());
  EXPECT_GT(findPieces(surface)[0].volume, 3);
}

TEST(Wrapping, TellsOptionsThatCannotBe)
{
  SurfaceMesh surface = ball(4);
  WrapReport report;
  EXPECT_FALSE(wrapSurface(surface, { 0, 0 }, {}, report).ok());
  EXPECT_FALSE(wrapSurface(surface, { 1, -1 }, {}, report).ok());
  const Outcome fine = wrapSurface(surface, { 1e-7, 0 }, {}, report);
  EXPECT_NE(fine.message.find("too many triangles"), std::string::npos);
  EXPECT_EQ(surface.triangles.size(), 192u);
}

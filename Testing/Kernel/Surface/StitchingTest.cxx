#include "Surface/Stitching.h"
#include "Surface/Diagnosis.h"
#include "Surface/Remedy.h"
#include "Surface/Repair.h"

#include "Triangles/SurfaceRepair.h"

#include "Support/RoundCube.h"

#include <gtest/gtest.h>

namespace
{
using namespace ransmesh;
using namespace ransmesh::test;

// A box without lid, of sides that are divided `around` times, and a lid with `other` points along each of its
// edges, a gap above.
SurfaceMesh boxWithLid(int around, int other, double gap)
{
  SurfaceMesh box = cube(around);
  SurfaceMesh lid = moved(cube(other), { 0, -gap, 0 });
  const auto only = [](SurfaceMesh& surface, bool isLid)
  {
    std::vector<char> stays;
    for (const int patch : surface.patch)
    {
      stays.push_back((patch == 3) == isLid);
    }
    keepTriangles(surface, stays);
  };
  only(box, false);
  only(lid, true);
  append(box, lid);
  mergeEqualPoints(box);
  return box;
}

bool isSound(const SurfaceMesh& surface)
{
  return diagnose(surface, {}, {}).isSound();
}
} // namespace

TEST(Stitching, ClosesRimsWithUnequalPoints)
{
  SurfaceMesh surface = boxWithLid(4, 7, 1e-3);
  PatchTable patches = sixPatches();
  EXPECT_FALSE(isSound(surface));
  EXPECT_NEAR(widthOfUnequalGaps(surface), 1e-3, 1e-9);
  RepairOptions options;
  options.weldTolerance = 1.1e-3; // the corners are welded, the others stitched
  const std::vector<Repair> repairs = repairSurface(surface, patches, options);
  ASSERT_EQ(repairs.size(), 2u);
  EXPECT_EQ(repairs[1].count, 4u * 3 + 4u * 6);
  EXPECT_TRUE(isSound(surface));
  EXPECT_EQ(surface.points.size(), cube(4).points.size() - 9u + 36u + 24u);
}

TEST(Stitching, MendsPointsOnANeighboursEdgeByItself)
{
  SurfaceMesh surface = boxWithLid(3, 6, 0);
  PatchTable patches = sixPatches();
  EXPECT_FALSE(isSound(surface));
  const std::vector<Repair> repairs = repairSurface(surface, patches, {});
  ASSERT_EQ(repairs.size(), 1u);
  EXPECT_EQ(repairs[0].count, 4u * 3);
  EXPECT_TRUE(isSound(surface));
}

TEST(Stitching, IsProposedWithATolerance)
{
  const SurfaceMesh surface = boxWithLid(4, 7, 1e-3);
  const std::string remedy = proposeRemedy(surface, sixPatches(), diagnose(surface, {}, {}));
  EXPECT_NE(remedy.find("(ransmesh --weld 0.001"), std::string::npos) << remedy;
}

TEST(Stitching, IsProposedWithHolesToFill)
{
  SurfaceMesh surface = boxWithLid(4, 7, 1e-3);
  surface.triangles.pop_back(); // in the lid
  surface.patch.pop_back();
  const std::string remedy = proposeRemedy(surface, sixPatches(), diagnose(surface, {}, {}));
  EXPECT_NE(remedy.find(" --fill-holes "), std::string::npos) << remedy;
  EXPECT_NE(remedy.find("(ransmesh --weld "), std::string::npos) << remedy;
}

TEST(Remedy, NamesThePlaneInWhichHalfModelsEnd)
{
  SurfaceMesh half = cube(4);
  std::vector<char> stays;
  for (const int patch : half.patch)
  {
    stays.push_back(patch != 3);
  }
  keepTriangles(half, stays);
  mergeEqualPoints(half);
  const std::string remedy = proposeRemedy(half, sixPatches(), diagnose(half, {}, {}));
  EXPECT_NE(remedy.find("fill the hole"), std::string::npos) << remedy;
  EXPECT_NE(remedy.find("(ransmesh --symmetry-plane y=-1)"), std::string::npos) << remedy;
}

TEST(Remedy, TellsAPatchThatMayBeASheet)
{
  SurfaceMesh withFin = cube(4);
  const auto first = static_cast<Index>(withFin.points.size());
  withFin.points.insert(withFin.points.end(), { { 2, 0, 0 }, { 2, 1, 0 }, { 2, 0, 1 } });
  withFin.triangles.push_back({ first, first + 1, first + 2 });
  withFin.patch.push_back(7);
  PatchTable patches = sixPatches();
  patches.resize(8);
  patches[7].name = "fin";
  const std::string remedy = proposeRemedy(withFin, patches, diagnose(withFin, {}, {}));
  EXPECT_NE(remedy.find("if 'fin' is a wake"), std::string::npos) << remedy;
}

TEST(Stitching, LeavesAnOpenSurfaceAlone)
{
  SurfaceMesh surface = boxWithLid(4, 7, 0.3);
  const SurfaceMesh before = surface;
  EXPECT_EQ(closeGaps(surface, 0.01).stitch.points, 0u);
  EXPECT_EQ(surface.triangles, before.triangles);
}

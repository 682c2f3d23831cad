#include "Boundary/Sheets.h"

#include "Boundary/SheetSides.h"
#include "Mesh/Builder.h"
#include "Mesh/Validation.h"
#include "Support/GridMesh.h"
#include "Support/Invariants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using namespace ransmesh;

bool isAtHalf(double x)
{
  return std::fabs(x - 0.5) < 1e-9;
}

class Sheets : public testing::Test
{
protected:
  void SetUp() override { patches_[7] = { "sheet", PatchType::Wake }; }

  // Cuts open, checks what must hold then, closes, and checks that nothing else changed. Gives the number of
  // points that the opened mesh has more.
  std::size_t openAndClose()
  {
    EXPECT_TRUE(findFaults(mesh_).none()) << findFaults(mesh_).text();
    const MeshData before = mesh_;
    OpenedSheets opened;
    EXPECT_TRUE(openSheets(mesh_, opened).ok());
    EXPECT_TRUE(opened.any());
    EXPECT_EQ(opened.origin.size(), mesh_.points.size());
    EXPECT_TRUE(findFaults(mesh_).none()) << findFaults(mesh_).text();
    EXPECT_TRUE(findSheets(mesh_).empty());
    EXPECT_NEAR(totalVolume(mesh_), totalVolume(before), 1e-13);
    const std::size_t more = mesh_.points.size() - before.points.size();
    // Through the kernel's mesh, which sorts the triangles.
    TetMesh built;
    EXPECT_TRUE(buildTetMesh(mesh_, built).ok());
    EXPECT_EQ(findFaults(built).brokenLinks, 0u);
    MeshData closed = toMeshData(built);
    std::vector<Index> number;
    EXPECT_TRUE(closeSheets(closed, opened.patches, number).ok());
    EXPECT_EQ(number.size(), mesh_.points.size());
    invariants::expectKept(before, closed);
    for (std::size_t v = 0; v < number.size(); ++v)
    {
      EXPECT_TRUE(closed.points[number[v]] == mesh_.points[v]);
      EXPECT_LT(opened.origin[v], static_cast<Index>(before.points.size()));
    }
    added_ = closed.points.size() - before.points.size();
    return more - added_;
  }

  MeshData mesh_ = grid_mesh::make({ 6, 6, 6 });
  PatchTable patches_ = grid_mesh::patches(PatchType::FarField, 7);
  std::size_t added_ = 0; // points that were needed to divide edges
};

TEST_F(Sheets, AMeshWithoutSheetsIsLeftAsItIs)
{
  const MeshData before = mesh_;
  OpenedSheets opened;
  EXPECT_TRUE(openSheets(mesh_, opened).ok());
  EXPECT_FALSE(opened.any());
  EXPECT_EQ(mesh_.triangles, before.triangles);
  EXPECT_FALSE(mesh_.isOpened);
}

TEST_F(Sheets, AFreeSheetOpensInsideAndStaysOneAtItsBorder)
{
  const int patch = grid_mesh::addSheet(mesh_,
    [](const Vector3& p) { return isAtHalf(p.z) && p.x > 0.17 && p.x < 0.83 && p.y > 0.17 && p.y < 0.83; });
  EXPECT_EQ(patch, 7);
  // 5 x 5 points, 3 x 3 of them inside, and the middles of the two edges that cut off a corner.
  EXPECT_EQ(openAndClose(), 9u + 2u);
  EXPECT_EQ(added_, 2u);
}

TEST_F(Sheets, AnOddlyShapedSheetIsDividedUntilItOpens)
{
  // One triangle, and a strip one cell wide: no point lies inside.
  grid_mesh::addSheet(mesh_,
    [](const Vector3& p) { return isAtHalf(p.z) && p.x > 0.17 && p.x < 0.83 && p.y > 0.34 && p.y < 0.5; });
  openAndClose();
  EXPECT_GT(added_, 0u);
  MeshData one = grid_mesh::make({ 6, 6, 6 });
  bool isTaken = false;
  grid_mesh::addSheet(one,
    [&isTaken](const Vector3& p)
    {
      const bool take = !isTaken && isAtHalf(p.z) && p.x > 0.4 && p.y > 0.4;
      isTaken = isTaken || take;
      return take;
    });
  mesh_ = one;
  EXPECT_EQ(openAndClose(), 1u);
  EXPECT_EQ(added_, 1u);
}

TEST_F(Sheets, ASheetAtAWallOpensThere)
{
  // A fin on the floor: its foot is doubled but at the two ends.
  grid_mesh::addSheet(
    mesh_, [](const Vector3& p) { return isAtHalf(p.x) && p.z < 0.5 && p.y > 0.17 && p.y < 0.83; });
  const std::size_t copies = openAndClose();
  EXPECT_EQ(copies - added_, 3u * 3u);
}

TEST_F(Sheets, ASheetBetweenTwoSidesOpensAtBoth)
{
  grid_mesh::addSheet(mesh_, [](const Vector3& p) { return isAtHalf(p.z) && p.x < 0.5; });
  EXPECT_EQ(openAndClose(), 3u * 7u);
  EXPECT_EQ(added_, 0u);
}

TEST_F(Sheets, ASheetMaySplitTheDomain)
{
  grid_mesh::addSheet(mesh_, [](const Vector3& p) { return isAtHalf(p.z); });
  EXPECT_EQ(openAndClose(), 7u * 7u);
}

TEST_F(Sheets, CrossingSheetsOpenInFourParts)
{
  grid_mesh::addSheet(mesh_, [](const Vector3& p) { return isAtHalf(p.z) || isAtHalf(p.x); });
  EXPECT_EQ(openAndClose(), 6u * 7u + 6u * 7u + 3u * 7u);
}

TEST_F(Sheets, AnotherPatchInsideIsASheetOfItsOwn)
{
  grid_mesh::addSheet(mesh_, [](const Vector3& p) { return isAtHalf(p.z) && p.x < 0.5; });
  grid_mesh::addSheet(mesh_, [](const Vector3& p) { return isAtHalf(p.z) && p.x > 0.5; });
  patches_.push_back({ "other", PatchType::Wall });
  EXPECT_EQ(openAndClose(), 7u * 7u);
}

TEST_F(Sheets, TheTriangleKeepsTheWayItIsTurned)
{
  grid_mesh::addSheet(mesh_, [](const Vector3& p) { return isAtHalf(p.z); });
  const auto height = [](const MeshData& mesh)
  {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
      const auto& v = mesh.triangles[i];
      const Vector3& a = mesh.points[v[0]];
      sum += mesh.trianglePatch[i] == 7 ? cross(mesh.points[v[1]] - a, mesh.points[v[2]] - a).z : 0;
    }
    return sum;
  };
  for (std::size_t i = 0; i < mesh_.triangles.size(); ++i)
  {
    auto& v = mesh_.triangles[i];
    const Vector3& a = mesh_.points[v[0]];
    if (mesh_.trianglePatch[i] == 7 && cross(mesh_.points[v[1]] - a, mesh_.points[v[2]] - a).z < 0)
    {
      std::swap(v[0], v[1]);
    }
  }
  const double before = height(mesh_);
  OpenedSheets opened;
  std::vector<Index> number;
  ASSERT_TRUE(openSheets(mesh_, opened).ok());
  EXPECT_NEAR(height(mesh_), 0, 1e-12);
  ASSERT_TRUE(closeSheets(mesh_, opened.patches, number).ok());
  EXPECT_NEAR(height(mesh_), before, 1e-12);
}

TEST_F(Sheets, SidesThatNoLongerFitAreAFault)
{
  grid_mesh::addSheet(mesh_, [](const Vector3& p) { return isAtHalf(p.z); });
  OpenedSheets opened;
  ASSERT_TRUE(openSheets(mesh_, opened).ok());
  mesh_.points.back().x += 1e-3;
  std::vector<Index> number;
  const Outcome outcome = closeSheets(mesh_, opened.patches, number);
  EXPECT_EQ(outcome.kind, Outcome::Kind::InternalFault);
  EXPECT_NE(outcome.message.find("do not fit together at ("), std::string::npos) << outcome.message;
}

TEST_F(Sheets, AnOpenMeshMustBeCutOpenBeforeItIsBuilt)
{
  grid_mesh::addSheet(mesh_, [](const Vector3& p) { return isAtHalf(p.z); });
  TetMesh built;
  EXPECT_NE(buildTetMesh(mesh_, built).message.find("cut open"), std::string::npos);
}

TEST_F(Sheets, APatchInsideAndOnTheBoundaryIsNoSheet)
{
  grid_mesh::addSheet(mesh_, [](const Vector3& p) { return isAtHalf(p.z); });
  std::replace(mesh_.trianglePatch.begin(), mesh_.trianglePatch.end(), 7, 6);
  EXPECT_TRUE(findSheets(mesh_).empty());
  EXPECT_EQ(findFaults(mesh_).trianglesOffTheBoundary, 72u);
}
} // namespace

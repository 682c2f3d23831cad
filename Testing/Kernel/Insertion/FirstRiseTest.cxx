#include "Insertion/FirstRise.h"

#include "Insertion/BaseFaces.h"
#include "Layers/ColumnBuilder.h"
#include "Mesh/Builder.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace ransmesh;
using namespace grid_mesh;

namespace
{
// A plate of three strips across x, each with a first height of its own: columns where two meet have that of the first.
struct Strips
{
  TetMesh mesh;
  ColumnSet set;
  std::vector<BaseFace> faces;

  explicit Strips(double growthToNext)
  {
    const auto strip = [](Side side, const Vector3& middle) {
      return side != ZLow || 3 * middle.x < 1 ? side : 3 * middle.x < 2 ? 7 : 8;
    };
    EXPECT_TRUE(buildTetMesh(make({ 3, 4, 2 }, strip), mesh).ok());
    LayerPlan plan(9);
    double height = 1e-3;
    for (const int patch : { static_cast<int>(ZLow), 7, 8 })
    {
      plan[patch].firstHeight = height;
      plan[patch].numberOfLayers = 3;
      height *= growthToNext;
    }
    set = buildColumns(mesh, BoundaryStars(mesh), patches(PatchType::Symmetry, 8), plan);
    faces = collectBaseFaces(mesh, set);
  }

  // How far the first height above the face is off, as a share of what its patch is to have.
  double missAbove(const BaseFace& face) const
  {
    const Column& first = set.columns[face.column[face.firstRise[0]]];
    return std::fabs(
      set.heightsOf(first).height(1) * first.direction.z / set.heights[face.patch].height(1) - 1);
  }
  std::size_t countWrong() const
  {
    return static_cast<std::size_t>(std::count_if(
      faces.begin(), faces.end(), [this](const BaseFace& face) { return missAbove(face) > 0.1; }));
  }
};
} // namespace

TEST(FirstRise, ColumnsThatAreRightAboveWhatIsLeftComeNext)
{
  // On the middle strip those where it meets the last one are right, on the last one they are not.
  Strips strips(1.2);
  EXPECT_GT(strips.countWrong(), 0U);
  orderFirstRise(strips.mesh, strips.faces, strips.set);
  EXPECT_EQ(strips.countWrong(), 0U);
}

TEST(FirstRise, WhereItDoesNotMatterThereIsNoRank)
{
  Strips strips(1.05);
  orderFirstRise(strips.mesh, strips.faces, strips.set);
  EXPECT_TRUE(std::all_of(
    strips.set.columns.begin(), strips.set.columns.end(), [](const Column& c) { return c.firstRank == 0; }));
}

TEST(FirstRise, WhereNoneIsRightTheNearestComesFirst)
{
  Strips strips(1);
  for (Column& c : strips.set.columns)
  {
    c.direction = 1.4 * c.direction;
  }
  Column& nearest = strips.set.columns[9];
  nearest.direction = { 0, 0, 1.2 };
  orderFirstRise(strips.mesh, strips.faces, strips.set);
  std::size_t found = 0;
  for (const BaseFace& face : strips.faces)
  {
    const bool hasNearest = std::find(face.column.begin(), face.column.end(), 9) != face.column.end();
    found += hasNearest;
    EXPECT_NEAR(strips.missAbove(face), hasNearest ? 0.2 : 0.4, 1e-9);
  }
  EXPECT_GE(found, 5U);
}

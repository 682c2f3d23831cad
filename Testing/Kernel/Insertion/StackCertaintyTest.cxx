#include "Insertion/StackCertainty.h"

#include "Geometry/Predicates.h"
#include "Insertion/LayerStacks.h"
#include "Layers/ColumnBuilder.h"
#include "Mesh/Builder.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace ransmesh;
using namespace grid_mesh;

namespace
{
// A plate with columns of these first heights, as far as 12 layers go, and the front at their tops.
struct RaisedPlate
{
  TetMesh mesh;
  ColumnSet set;
  std::vector<BaseFace> faces;

  RaisedPlate(double firstHeight, const Vector3& origin)
  {
    Grid grid{ 6, 6, 2 };
    grid.map = [origin](const Vector3& p) { return origin + turned(p); };
    EXPECT_TRUE(buildTetMesh(make(grid), mesh).ok());
    LayerPlan plan(7);
    plan[ZLow].firstHeight = firstHeight;
    plan[ZLow].numberOfLayers = 12;
    set = buildColumns(mesh, BoundaryStars(mesh), patches(PatchType::Symmetry), plan);
    raise();
    faces = collectBaseFaces(mesh, set);
  }
  void raise()
  {
    for (const Column& c : set.columns)
    {
      mesh.movePoint(c.vertex, set.pointAt(c, c.levels));
    }
  }
  // Leans the columns at random by up to so much, and cuts them at random.
  void disturb(double lean, std::mt19937& random)
  {
    std::uniform_real_distribution<double> share(-lean, lean);
    for (Column& c : set.columns)
    {
      c.direction = c.direction + Vector3{ share(random), share(random), share(random) };
      c.levels = std::uniform_int_distribution<int>(1, 12)(random);
    }
    raise();
  }
  // Is every tetrahedron of the face's stack positive? One after the other.
  bool stands(const BaseFace& face) const
  {
    std::array<Vector3, 3> current = basePoints(mesh, set, face);
    bool positive = true;
    forEachRise(stackOf(set, face),
      [&](int below, int corner, bool)
      {
        const Vector3 risen = set.pointAt(set.columns[face.column[corner]], below + 1);
        positive = positive && isPositive(current[0], current[1], current[2], risen);
        current[corner] = risen;
      });
    return positive;
  }
  std::size_t countSure() const
  {
    return static_cast<std::size_t>(std::count_if(
      faces.begin(), faces.end(), [this](const BaseFace& f) { return isSurelyPositive(mesh, set, f); }));
  }
};

TEST(StackCertainty, IsSureOfPlainStacks)
{
  for (const double firstHeight : { 1e-9, 1e-6, 1e-3 })
  {
    const RaisedPlate plate(firstHeight, { 3, -2, 5 });
    EXPECT_EQ(plate.faces.size(), 72u);
    EXPECT_EQ(plate.countSure(), 72u) << firstHeight;
  }
}

TEST(StackCertainty, IsNotSureWhereRoundingDecides)
{
  // Heights of 1e-13 at coordinates of 1000: hardly a digit is left.
  EXPECT_EQ(RaisedPlate(1e-13, { 1000, 1000, 1000 }).countSure(), 0u);
}

TEST(StackCertainty, IsNeverSureOfAStackThatFolds)
{
  std::mt19937 random(3);
  std::size_t sure = 0;
  std::size_t folded = 0;
  for (int round = 0; round < 200; ++round)
  {
    RaisedPlate plate(round % 2 == 0 ? 1e-3 : 1e-2, { 1, 2, 3 });
    plate.disturb(0.05 * (round % 20), random);
    for (const BaseFace& face : plate.faces)
    {
      const bool isSure = isSurelyPositive(plate.mesh, plate.set, face);
      const bool stands = plate.stands(face);
      EXPECT_TRUE(stands || !isSure);
      folded += !stands;
      sure += isSure;
    }
  }
  EXPECT_GT(folded, 100u);
  EXPECT_GT(sure, 1000u);
}
} // namespace

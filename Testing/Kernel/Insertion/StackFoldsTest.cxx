// Stacks of layers that fold: found, and mended by lowering columns.
#include "Insertion/StackFolds.h"

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
// A plate of n x n cells, with columns of twelve layers of 0.02.
struct Plate
{
  TetMesh mesh;
  ColumnSet set;
  std::vector<BaseFace> faces;

  explicit Plate(int n)
  {
    EXPECT_TRUE(buildTetMesh(make({ n, n, 1 }), mesh).ok());
    LayerPlan plan(7);
    plan[ZLow].firstHeight = 0.02;
    plan[ZLow].growthRate = 1;
    plan[ZLow].numberOfLayers = 12;
    set = buildColumns(mesh, BoundaryStars(mesh), patches(PatchType::Symmetry), plan);
    faces = collectBaseFaces(mesh, set);
  }

  // Leans the columns by up to so much, and cuts them to so many levels or more, at random.
  void disturb(double lean, int fewest, std::mt19937& random)
  {
    std::uniform_real_distribution<double> share(-lean, lean);
    for (Column& c : set.columns)
    {
      c.direction = c.direction + Vector3{ share(random), share(random), share(random) };
      c.levels = std::uniform_int_distribution<int>(fewest, 12)(random);
    }
  }
  void raise()
  {
    for (const Column& c : set.columns)
    {
      mesh.movePoint(c.vertex, set.pointAt(c, c.levels));
    }
  }

  // Is every tetrahedron of the face's stack positive? One after the other, the tops where the mesh has them or as
  // planned.
  bool stands(const BaseFace& face, bool asPlanned) const
  {
    std::array<Vector3, 3> current = basePoints(mesh, set, face);
    bool positive = true;
    forEachRise(stackOf(set, face),
      [&](int below, int corner, bool)
      {
        const Column& c = set.columns[face.column[corner]];
        const bool isTop = below + 1 == c.levels;
        const Vector3 risen = isTop && !asPlanned ? mesh.point(c.vertex) : set.pointAt(c, below + 1);
        positive = positive && isPositive(current[0], current[1], current[2], risen);
        current[corner] = risen;
      });
    return positive;
  }
  std::vector<Index> folded() const
  {
    std::vector<Index> result;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      if (!stands(faces[i], false))
      {
        result.push_back(static_cast<Index>(i));
      }
    }
    return result;
  }
};
} // namespace

TEST(StackFolds, EveryStackThatFoldsIsFound)
{
  std::mt19937 random(5);
  std::size_t folded = 0;
  for (int round = 0; round < 100; ++round)
  {
    Plate plate(4);
    plate.disturb(0.1 * (round % 15), 1, random);
    plate.raise();
    EXPECT_EQ(findFoldedStacks(plate.mesh, plate.set, plate.faces), plate.folded());
    folded += plate.folded().size();
  }
  EXPECT_GT(folded, 100U);
}

TEST(StackFolds, ATopThatIsNotWhereItWasPlannedIsSeenWhereItIs)
{
  Plate plate(4);
  plate.raise();
  EXPECT_TRUE(findFoldedStacks(plate.mesh, plate.set, plate.faces).empty());
  const Column& c = plate.set.columns[12];
  plate.mesh.movePoint(c.vertex, plate.set.pointAtHeight(c, 0.5 * plate.set.thickness(c)));
  EXPECT_FALSE(plate.folded().empty());
  EXPECT_EQ(findFoldedStacks(plate.mesh, plate.set, plate.faces), plate.folded());
}

TEST(StackFolds, NoStackFoldsAsPlannedWhenTheColumnsAreLimited)
{
  std::mt19937 random(7);
  std::size_t lowered = 0;
  for (int round = 0; round < 100; ++round)
  {
    Plate plate(4);
    plate.disturb(0.1 * (round % 15), 1, random);
    limitByFolds(plate.mesh, collectBaseFaces(plate.mesh, plate.set), plate.set);
    for (const BaseFace& face : collectBaseFaces(plate.mesh, plate.set))
    {
      EXPECT_TRUE(plate.stands(face, true)) << round;
    }
    lowered += static_cast<std::size_t>(std::count_if(plate.set.columns.begin(), plate.set.columns.end(),
      [](const Column& c) { return c.reason == StopReason::Corner; }));
  }
  EXPECT_GT(lowered, 100U);
}

TEST(StackFolds, WhereALittleIsEnoughColumnsKeepTheirLayers)
{
  Plate plate(4);
  Column& leaning = plate.set.columns[12];
  leaning.direction = { 1.15, 0, 1 }; // its top would come past the next one's
  const auto standsAsPlanned = [&plate](const BaseFace& face) { return plate.stands(face, true); };
  EXPECT_FALSE(std::all_of(plate.faces.begin(), plate.faces.end(), standsAsPlanned));
  EXPECT_TRUE(limitByFolds(plate.mesh, plate.faces, plate.set).empty());
  EXPECT_TRUE(std::all_of(plate.faces.begin(), plate.faces.end(), standsAsPlanned));
  for (const Column& c : plate.set.columns)
  {
    EXPECT_EQ(c.levels, 12);
    EXPECT_EQ(c.reason, StopReason::Complete);
  }
  EXPECT_LT(plate.set.thickness(leaning), 0.23);
}

TEST(StackFolds, WhatFoldsWithColumnsThatCannotBeLoweredIsTold)
{
  Plate plate(4);
  EXPECT_TRUE(limitByFolds(plate.mesh, collectBaseFaces(plate.mesh, plate.set), plate.set).empty());
  Column& down = plate.set.columns[12];
  down.direction = -1 * down.direction;
  down.levels = down.lowest = 1;
  const auto facesAtIt = static_cast<std::size_t>(std::count_if(plate.faces.begin(), plate.faces.end(),
    [](const BaseFace& f) { return std::find(f.column.begin(), f.column.end(), 12) != f.column.end(); }));
  // Its top may still rise from where it is.
  plate.mesh.movePoint(down.vertex, plate.set.pointAtHeight(down, -0.01));
  EXPECT_TRUE(limitByFolds(plate.mesh, collectBaseFaces(plate.mesh, plate.set), plate.set).empty());
  plate.mesh.movePoint(down.vertex, plate.set.pointAt(down, 1));
  EXPECT_EQ(limitByFolds(plate.mesh, collectBaseFaces(plate.mesh, plate.set), plate.set).size(), facesAtIt);
}

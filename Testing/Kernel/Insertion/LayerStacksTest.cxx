#include "Insertion/LayerStacks.h"
#include "Insertion/StackFolds.h"

#include "Layers/ColumnBuilder.h"
#include "Mesh/Builder.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace ransmesh;
using namespace grid_mesh;

namespace
{
// A plate with columns of three layers, the front still on the wall.
struct Plate
{
  TetMesh mesh;
  ColumnSet set;

  Plate()
  {
    EXPECT_TRUE(buildTetMesh(make({ 3, 3, 3 }), mesh).ok());
    LayerPlan plan(7);
    plan[ZLow].firstHeight = 0.01;
    plan[ZLow].numberOfLayers = 3;
    set = buildColumns(mesh, BoundaryStars(mesh), patches(PatchType::Symmetry), plan);
  }
  // Puts all tops where their columns end.
  void raise()
  {
    for (const Column& c : set.columns)
    {
      mesh.movePoint(c.vertex, set.pointAt(c, c.levels));
    }
  }
};
} // namespace

TEST(LayerStacks, BaseFacesAreTheWallAndKnowTheirSides)
{
  const Plate plate;
  std::vector<BaseFace> faces = collectBaseFaces(plate.mesh, plate.set);
  EXPECT_EQ(faces.size(), 18u);
  findSides(plate.mesh, plate.set, faces);
  std::map<int, int> sides;
  for (const BaseFace& face : faces)
  {
    EXPECT_EQ(face.patch, ZLow);
    for (const int patch : face.sideOpposite)
    {
      ++sides[patch];
    }
  }
  for (const int side : { XLow, XHigh, YLow, YHigh })
  {
    EXPECT_EQ(sides[side], 3) << side;
  }
}

namespace
{
// level, corner, is it flat
using Rises = std::vector<std::tuple<int, int, bool>>;

Rises risesOf(const Stack& stack)
{
  Rises rises;
  forEachRise(stack, [&](int level, int corner, bool isFlat) { rises.emplace_back(level, corner, isFlat); });
  return rises;
}
} // namespace

TEST(LayerStacks, CornersRiseLevelByLevelInOneOrder)
{
  Plate plate;
  plate.set.columns[1].levels = 1;
  BaseFace face;
  face.column = { None, 0, 1 }; // a column without levels does not stand
  face.root = { 5, 6, 7 };
  face.rise = { 0, 1, 2 };
  face.firstRise = face.rise;
  const Rises wanted = { { 0, 1, false }, { 0, 2, false }, { 1, 1, false }, { 2, 1, false } };
  EXPECT_EQ(risesOf(stackOf(plate.set, face)), wanted);
}

TEST(LayerStacks, InTheFirstLevelColumnsRiseByTheirRank)
{
  Plate plate;
  plate.set.columns[1].firstRank = 3;
  plate.set.columns[2].firstRank = 1;
  bool found = false;
  for (const BaseFace& face : collectBaseFaces(plate.mesh, plate.set))
  {
    const auto inOrder = [&face](const std::array<int, 3>& rise) {
      return std::array{ face.column[rise[0]], face.column[rise[1]], face.column[rise[2]] };
    };
    const auto columns = inOrder(face.rise);
    EXPECT_TRUE(std::is_sorted(columns.begin(), columns.end()));
    const auto firstRank = [&plate](Index c) { return plate.set.columns[c].firstRank; };
    const auto first = inOrder(face.firstRise);
    EXPECT_TRUE(std::is_sorted(first.begin(), first.end(),
      [&](Index a, Index b) { return std::pair(firstRank(a), a) < std::pair(firstRank(b), b); }));
    if (columns != first)
    {
      found = true;
      const Rises rises = risesOf(stackOf(plate.set, face));
      EXPECT_EQ(std::get<1>(rises[0]), face.firstRise[0]);
      EXPECT_EQ(std::get<1>(rises[3]), face.rise[0]);
    }
  }
  EXPECT_TRUE(found);
}

TEST(LayerStacks, TetrahedraWithOnePointTwiceAreFlat)
{
  // Two columns on one root: the first to rise makes no tetrahedron.
  const Stack edge{ { 3, 3, 8 }, { 2, 2, 2 }, { 0, 1, 2 } };
  const Rises onEdge = { { 0, 0, true }, { 0, 1, false }, { 0, 2, false }, { 1, 0, false }, { 1, 1, false },
    { 1, 2, false } };
  EXPECT_EQ(risesOf(edge), onEdge);
  EXPECT_EQ(countTets(edge), 5u);
  // The single one first: it stays flat until one of the two has risen.
  const Stack single{ { 3, 3, 8 }, { 1, 1, 1 }, { 0, 1, 2 }, { 2, 0, 1 } };
  EXPECT_EQ(countTets(single), 1u);
  // Three columns on one root.
  const Stack point{ { 3, 3, 3 }, { 2, 2, 2 }, { 0, 1, 2 } };
  EXPECT_EQ(countTets(point), 4u);
}

TEST(LayerStacks, CountsAndNumbersAgree)
{
  Plate plate;
  plate.set.columns[5].levels = 1;
  const std::vector<BaseFace> faces = collectBaseFaces(plate.mesh, plate.set);
  std::vector<Index> same(plate.mesh.vertexCount());
  for (std::size_t i = 0; i < same.size(); ++i)
  {
    same[i] = static_cast<Index>(i);
  }
  const ColumnPoints numbers(plate.set, same, same.size());
  EXPECT_EQ(numbers.count(), 15u * 3u + 1u);
  EXPECT_EQ(numbers.at(0, 0), plate.set.columns[0].vertex);
  EXPECT_EQ(numbers.at(0, 1), static_cast<Index>(same.size()));
  EXPECT_EQ(numbers.at(6, 1), numbers.at(5, 1) + 1);

  MeshData out;
  std::vector<int> layer;
  std::vector<Index> stacks;
  StackSink sink{ out.tetrahedra, layer, stacks, out.triangles, out.trianglePatch };
  StackWriter writer(sink);
  std::size_t count = 0;
  for (const BaseFace& face : faces)
  {
    const Stack stack = stackOf(plate.set, face);
    count += countTets(stack);
    writer.write(stack, face.sideOpposite,
      [&](int corner, int level) { return numbers.at(face.column[corner], level); });
  }
  EXPECT_EQ(out.tetrahedra.size(), count);
  EXPECT_EQ(layer.size(), count);
  ASSERT_EQ(stacks.size(), faces.size());
  EXPECT_EQ(stacks[0], 0);
  EXPECT_EQ(stacks[1], static_cast<Index>(countTets(stackOf(plate.set, faces[0]))));
}

TEST(StackFolds, CleanStacksDoNotFold)
{
  Plate plate;
  plate.raise();
  const std::vector<BaseFace> faces = collectBaseFaces(plate.mesh, plate.set);
  EXPECT_TRUE(findFoldedStacks(plate.mesh, plate.set, faces).empty());
}

TEST(StackFolds, CrossingColumnsAreFoundAndMended)
{
  Plate plate;
  Column& c = plate.set.columns[5]; // not at the edge
  c.direction = { 40, 0, 1 };       // crosses its neighbours
  plate.raise();
  const std::vector<BaseFace> faces = collectBaseFaces(plate.mesh, plate.set);
  EXPECT_FALSE(findFoldedStacks(plate.mesh, plate.set, faces).empty());
  std::vector<Index> left;
  EXPECT_TRUE(mendFolds(plate.mesh, plate.set, left));
  EXPECT_TRUE(left.empty());
  EXPECT_TRUE(findFoldedStacks(plate.mesh, plate.set, collectBaseFaces(plate.mesh, plate.set)).empty());
}

TEST(StackFolds, PlannedColumnsThatCrossAreLowered)
{
  Plate plate;
  Column& c = plate.set.columns[5];
  c.direction = { 40, 0, 1 };
  limitByFolds(plate.mesh, collectBaseFaces(plate.mesh, plate.set), plate.set);
  EXPECT_LT(c.levels, 3);
  EXPECT_EQ(c.reason, StopReason::Corner);
  plate.raise();
  std::vector<Index> left;
  EXPECT_TRUE(mendFolds(plate.mesh, plate.set, left));
  EXPECT_TRUE(left.empty());
}

TEST(StackFolds, ATopIsLoweredOnlyWhereTheMeshStaysValid)
{
  Plate plate;
  plate.raise();
  const Column before = plate.set.columns[5];
  EXPECT_TRUE(lowerTop(plate.mesh, plate.set, 5, 1));
  EXPECT_EQ(plate.set.columns[5].levels, 1);
  EXPECT_EQ(plate.set.columns[5].reason, StopReason::Refused);
  EXPECT_EQ(plate.mesh.point(before.vertex), plate.set.pointAt(before, 1));
}

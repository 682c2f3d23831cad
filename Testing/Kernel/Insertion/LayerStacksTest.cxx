#include "Insertion/LayerStacks.h"
#include "Insertion/StackFolds.h"

#include "Layers/ColumnBuilder.h"
#include "Mesh/Builder.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

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

TEST(LayerStacks, CornersRiseLevelByLevelInOneOrder)
{
  Plate plate;
  plate.set.columns[1].levels = 1;
  plate.set.columns[2].levels = 0;
  BaseFace face;
  face.column = { 2, 0, 1 };
  face.column[0] = None; // a column without levels does not stand
  face.rise = { 0, 1, 2 };
  std::vector<std::pair<int, int>> rises;
  forEachRise(plate.set, face, [&](int level, int corner, bool) { rises.emplace_back(level, corner); });
  const std::vector<std::pair<int, int>> wanted = { { 0, 1 }, { 0, 2 }, { 1, 1 }, { 2, 1 } };
  EXPECT_EQ(rises, wanted);
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
  std::vector<Index> prism;
  StackSink sink{ out.tetrahedra, layer, prism, out.triangles, out.trianglePatch };
  writeStacks(plate.set, faces, numbers, same, sink);
  EXPECT_EQ(out.tetrahedra.size(), countStackTets(plate.set, faces));
  EXPECT_EQ(layer.size(), out.tetrahedra.size());
  EXPECT_EQ(prism.size(), out.tetrahedra.size());
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
}

TEST(StackFolds, PlannedColumnsThatCrossAreLowered)
{
  Plate plate;
  Column& c = plate.set.columns[5];
  c.direction = { 40, 0, 1 };
  limitByFolds(plate.mesh, plate.set);
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

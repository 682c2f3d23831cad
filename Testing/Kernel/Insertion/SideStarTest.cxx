// Which triangles of a side may be replaced when a top moves along it.
#include "Insertion/SideStar.h"

#include "Layers/ColumnBuilder.h"
#include "Mesh/Builder.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

using namespace ransmesh;
using namespace grid_mesh;

namespace
{
// A cube on a floor with columns; its four upright sides are one patch.
class OneSideAround : public testing::Test
{
protected:
  static constexpr int Around = XLow;

  void SetUp() override
  {
    const auto around = [](Side side, const Vector3&)
    { return side == ZLow || side == ZHigh ? static_cast<int>(side) : Around; };
    ASSERT_TRUE(buildTetMesh(make({ 4, 4, 4 }, around), mesh_).ok());
    LayerPlan plan(7);
    plan[ZLow].firstHeight = 0.01;
    plan[ZLow].numberOfLayers = 3;
    const PatchTable table = patches(PatchType::Symmetry);
    set_ = buildColumns(mesh_, BoundaryStars(mesh_), table, plan);
    classes_ = classify(mesh_, table);
    turns_ = std::make_unique<SideTurns>(mesh_, set_, 10);
    star_ = std::make_unique<SideStar>(mesh_, classes_, *turns_);
  }

  Index vertexAt(const Vector3& x) const
  {
    for (std::size_t v = 0; v < mesh_.vertexCount(); ++v)
    {
      if (distance(mesh_.point(static_cast<Index>(v)), x) < 1e-9)
      {
        return static_cast<Index>(v);
      }
    }
    throw std::logic_error("no vertex there");
  }
  const Column& columnAt(const Vector3& x) const { return set_.columns[set_.ofVertex[vertexAt(x)]]; }
  // The side's faces that have all of these vertices.
  std::vector<Index> facesWith(const std::vector<Index>& vertices) const
  {
    std::vector<Index> faces;
    for (std::size_t i = 0; i < mesh_.boundarySlots(); ++i)
    {
      const auto b = static_cast<Index>(i);
      const auto v = mesh_.boundaryVertices(b);
      const bool hasAll = std::all_of(vertices.begin(), vertices.end(),
        [&v](Index w) { return std::find(v.begin(), v.end(), w) != v.end(); });
      if (mesh_.boundaryFace(b).patch == Around && hasAll)
      {
        faces.push_back(b);
      }
    }
    return faces;
  }
  bool allows(const std::vector<Index>& faces, Index top, const std::vector<Index>& lost = {})
  {
    Cavity cavity;
    cavity.starredFaces = faces;
    return star_->allowsStar(cavity, top, lost);
  }

  TetMesh mesh_;
  ColumnSet set_;
  Classification classes_;
  std::unique_ptr<SideTurns> turns_;
  std::unique_ptr<SideStar> star_;
};
} // namespace

TEST_F(OneSideAround, FacesAtTheTopMayBeStarred)
{
  const Index top = vertexAt({ 0, 0.5, 0 });
  EXPECT_TRUE(allows(facesWith({ top }), top));
}

TEST_F(OneSideAround, FacesThatDoNotHangTogetherMayNot)
{
  const Index top = vertexAt({ 0, 0.5, 0 });
  std::vector<Index> faces = facesWith({ top });
  faces.push_back(facesWith({ vertexAt({ 1, 0.5, 0.5 }) }).front());
  EXPECT_FALSE(allows(faces, top));
}

TEST_F(OneSideAround, NoRidgeMayVanish)
{
  const std::vector<Index> upright = { vertexAt({ 0, 0, 0.25 }), vertexAt({ 0, 0, 0.5 }) };
  const std::vector<Index> faces = facesWith(upright);
  ASSERT_EQ(faces.size(), 2U);
  for (const Index face : faces)
  {
    const auto v = mesh_.boundaryVertices(face);
    const Index top =
      *std::find_if(v.begin(), v.end(), [&](Index w) { return w != upright[0] && w != upright[1]; });
    EXPECT_TRUE(allows({ face }, top));
    EXPECT_FALSE(allows(faces, top));
  }
}

TEST_F(OneSideAround, NoVertexMayBeLeftInside)
{
  const Index inside = vertexAt({ 0, 0.5, 0.25 });
  const Index top = vertexAt({ 0, 0.5, 0 });
  EXPECT_TRUE(allows(facesWith({ inside }), top, { inside }));
  EXPECT_FALSE(allows(facesWith({ inside }), top));
}

TEST_F(OneSideAround, OnlyPointsOfTheSideMayGo)
{
  const Column& column = columnAt({ 0, 0.5, 0 });
  EXPECT_TRUE(star_->mayLose(column, vertexAt({ 0, 0.5, 0.25 })));
  EXPECT_FALSE(star_->mayLose(column, vertexAt({ 0, 0, 0.25 })));  // on a ridge between parts of it
  EXPECT_FALSE(star_->mayLose(column, vertexAt({ 0, 0.25, 0 })));  // of the wall, too
  EXPECT_FALSE(star_->mayLose(column, vertexAt({ 0.5, 0.5, 1 }))); // of the lid
  EXPECT_FALSE(star_->mayLose(column, vertexAt({ 0, 0.25, 1 })));  // of the lid, too
  classes_.frozen[vertexAt({ 0, 0.5, 0.25 })] = 1;
  EXPECT_FALSE(star_->mayLose(column, vertexAt({ 0, 0.5, 0.25 })));
}

TEST_F(OneSideAround, OnItsRidgeTheTopTakesTheNextPointAlone)
{
  const Column& column = columnAt({ 0, 0, 0 });
  ASSERT_NE(column.sides[1], 0);
  EXPECT_TRUE(star_->mayLose(column, vertexAt({ 0, 0, 0.25 })));
  EXPECT_FALSE(star_->mayLose(column, vertexAt({ 0, 0, 0.5 })));
  mesh_.movePoint(vertexAt({ 0, 0, 0.5 }), { 0.1, 0.1, 0.5 }); // the ridge turns by 29 degrees
  EXPECT_FALSE(star_->mayLose(column, vertexAt({ 0, 0, 0.25 })));
}

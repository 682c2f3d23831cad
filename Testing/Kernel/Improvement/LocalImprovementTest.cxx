#include "Improvement/LocalImprovement.h"

#include "Support/GridMesh.h"
#include "Support/Invariants.h"

#include <gtest/gtest.h>

using namespace ransmesh;

namespace
{
class LocalImprovements : public testing::Test
{
protected:
  // The first point of the volume.
  Index inner() const
  {
    Index v = 0;
    while (rules_.classification.kind[v] != VertexKind::Volume)
    {
      ++v;
    }
    return v;
  }

  TetMesh mesh_ = invariants::build(grid_mesh::make({ 4, 4, 4, grid_mesh::turned, 0.25 }));
  PatchTable patches_ = grid_mesh::patches(PatchType::Symmetry);
  BoundaryRules rules_{ classify(mesh_, patches_), std::vector<char>(patches_.size(), 0) };
  LocalImprovement improvement_{ mesh_, rules_ };
};
} // namespace

TEST_F(LocalImprovements, TetrahedraStayPositiveWhateverQualityIsAskedFor)
{
  // A floor below all qualities lets everything pass but what is not exactly positive.
  constexpr double none = -1e3;
  const Index v = inner();
  const Vector3 from = mesh_.point(v);
  const Vector3 far = from + Vector3{ 10, 0, 0 };
  EXPECT_FALSE(improvement_.moveTowards(v, far, none));
  EXPECT_EQ(mesh_.point(v), from);
  EXPECT_TRUE(improvement_.moveTowards(v, from + Vector3{ 0.3, 0.02, 0.01 }, none));
  invariants::expectValid(mesh_);
}

TEST_F(LocalImprovements, PointsOfTheBoundaryStay)
{
  const Index v = mesh_.boundaryVertices(0)[0];
  EXPECT_FALSE(improvement_.move(v, 0));
  EXPECT_FALSE(improvement_.moveTowards(v, { 0.5, 0.5, 0.5 }, 0));
}

TEST_F(LocalImprovements, SwapsAreNotTriedWhereNothingHasChanged)
{
  std::vector<std::uint32_t> changedAt(mesh_.tetSlots(), 3);
  std::size_t swapped = 0;
  for (Index t = 0; t < static_cast<Index>(mesh_.tetSlots()); ++t)
  {
    EXPECT_FALSE(!mesh_.tet(t).isAlive() || improvement_.swap(t, { 0b1111, &changedAt, 3, 3 }));
  }
  for (Index t = 0; t < static_cast<Index>(changedAt.size()); ++t)
  {
    changedAt.resize(mesh_.tetSlots(), 3);
    swapped += mesh_.tet(t).isAlive() && improvement_.swap(t, { 0b1111, &changedAt, 2, 3 });
  }
  EXPECT_GT(swapped, 0U);
  invariants::expectValid(mesh_);
}

TEST_F(LocalImprovements, ShapesAreThoseOfTheTetrahedraThatAreThere)
{
  constexpr double any = 10; // above all shapes
  const auto expectTrueShapes = [&](LocalImprovement& used)
  {
    LocalImprovement fresh(mesh_, rules_);
    for (Index t = 0; t < static_cast<Index>(mesh_.tetSlots()); ++t)
    {
      EXPECT_TRUE(!mesh_.tet(t).isAlive() || used.shapeOf(t, any) == fresh.shapeOf(t, any)) << t;
    }
  };
  expectTrueShapes(improvement_); // known from now on
  std::size_t swapped = 0;
  for (Index t = 0; t < static_cast<Index>(mesh_.tetSlots()); ++t)
  {
    swapped += mesh_.tet(t).isAlive() && improvement_.swap(t);
  }
  EXPECT_GT(swapped, 0U);
  expectTrueShapes(improvement_);
  EXPECT_TRUE(improvement_.moveTowards(inner(), mesh_.point(inner()) + Vector3{ 0.02, 0.01, 0 }, 0));
  expectTrueShapes(improvement_);
}

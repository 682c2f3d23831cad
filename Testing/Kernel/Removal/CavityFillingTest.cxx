#include "Removal/CavityFilling.h"

#include "Geometry/Predicates.h"
#include "Support/WallStar.h"

#include <gtest/gtest.h>

namespace
{
using namespace ransmesh;
using Verdict = CavityFilling::Verdict;

constexpr std::size_t Enough = 10000;

double sixVolumeOf(const CavityFilling& filling, const std::vector<Vector3>& p)
{
  double sum = 0;
  for (const auto& t : filling.tets())
  {
    EXPECT_TRUE(isPositive(p[t[0]], p[t[1]], p[t[2]], p[t[3]]));
    sum += sixVolumes(p[t[0]], p[t[1]], p[t[2]], p[t[3]]);
  }
  return sum;
}

TEST(CavityFilling, FillsWhatNoCornerSeesWhole)
{
  const wall_star::Polyhedron cube = wall_star::cube();
  CavityFilling filling;
  filling.turnTo(cube.points, cube.faces);
  ASSERT_EQ(filling.fill(0, Enough), Verdict::Filled);
  EXPECT_EQ(filling.tets().size(), 6u);
  EXPECT_DOUBLE_EQ(sixVolumeOf(filling, cube.points), 6);
}

TEST(CavityFilling, UsesPointsInside)
{
  wall_star::Polyhedron cube = wall_star::cube();
  cube.points.push_back({ 0.4, 0.5, 0.6 });
  CavityFilling filling;
  filling.turnTo(cube.points, cube.faces);
  ASSERT_EQ(filling.fill(0.05, Enough), Verdict::Filled);
  EXPECT_NEAR(sixVolumeOf(filling, cube.points), 6, 1e-14);
  EXPECT_TRUE(std::any_of(filling.tets().begin(), filling.tets().end(),
    [](const auto& tet) { return std::find(tet.begin(), tet.end(), 8) != tet.end(); }));
}

TEST(CavityFilling, KnowsThatSchoenhardtsPolyhedronHasNoFilling)
{
  wall_star::Polyhedron body = wall_star::schoenhardt();
  CavityFilling filling;
  filling.turnTo(body.points, body.faces);
  EXPECT_EQ(filling.fill(0, Enough), Verdict::Impossible);
  body.points.push_back({ 0, 0, 0.5 });
  filling.turnTo(body.points, body.faces);
  ASSERT_EQ(filling.fill(0, Enough), Verdict::Filled);
  EXPECT_EQ(filling.tets().size(), 8u);
}

TEST(CavityFilling, KeepsToTheFloorAndToItsSteps)
{
  const wall_star::Polyhedron cube = wall_star::cube();
  CavityFilling filling;
  filling.turnTo(cube.points, cube.faces);
  EXPECT_EQ(filling.fill(0.9, Enough), Verdict::Impossible);
  EXPECT_EQ(filling.fill(0, 3), Verdict::GivenUp);
  EXPECT_EQ(filling.stepsLeft(), 0u);
  EXPECT_EQ(filling.fill(0, Enough), Verdict::Filled); // what was found before does no harm
}
} // namespace

#include "Layers/Directions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace ransmesh;

namespace
{
constexpr double Degree = std::numbers::pi / 180;

FaceAtVertex faceWith(const Vector3& normal, double angle)
{
  FaceAtVertex face{};
  face.normal = normal;
  face.angle = angle;
  return face;
}

// A normal that leans from z by so many degrees towards x.
Vector3 leaning(double degrees)
{
  return { std::sin(degrees * Degree), 0, std::cos(degrees * Degree) };
}

} // namespace

TEST(EvenStep, RisesAlikeAboveTheFacesOfAValley)
{
  const std::vector<FaceAtVertex> walls = { faceWith(leaning(25), 2.5), faceWith(leaning(-25), 0.5) };
  const Vector3 d = weightedNormal(walls);
  EXPECT_LT(dot(walls[1].normal, scaledStep(walls, d)), 0.85); // the mean leans to the wider face
  const Vector3 even = evenStep(walls, SideProjection({}), d);
  EXPECT_NEAR(dot(walls[0].normal, even), 1, 0.01);
  EXPECT_NEAR(dot(walls[1].normal, even), 1, 0.01);
}

TEST(EvenStep, HalvesWhatItMustMiss)
{
  const std::vector<FaceAtVertex> walls = { faceWith(leaning(30), 0.2), faceWith({ 0, 0, 1 }, 4),
    faceWith(leaning(-30), 0.2) };
  const Vector3 even = evenStep(walls, SideProjection({}), { 0, 0, 1 });
  for (const FaceAtVertex& f : walls) // 1 and cos 30 = 0.866 become 1.07 and 0.93
  {
    EXPECT_NEAR(dot(f.normal, even), 1, 0.075);
  }
}

TEST(EvenStep, RisesRightAboveMostWhereItCannotAboveAll)
{
  const std::vector<FaceAtVertex> walls = { faceWith(leaning(50), 0.1), faceWith({ 0, 0, 1 }, 4),
    faceWith(leaning(-50), 0.1) };
  EXPECT_EQ(evenStep(walls, SideProjection({}), { 0, 0, 1 }), scaledStep(walls, { 0, 0, 1 }));
}

TEST(EvenStep, StaysInTheSides)
{
  const Vector3 side = { 0, 1, 0 };
  const std::vector<FaceAtVertex> walls = { faceWith(normalized({ 0.4, 0.2, 1 }), 2),
    faceWith(normalized({ -0.6, 0.2, 1 }), 0.5) };
  const SideProjection lay({ side });
  const Vector3 even = evenStep(walls, lay, lay(weightedNormal(walls)));
  EXPECT_EQ(dot(even, side), 0);
  EXPECT_NEAR(dot(walls[0].normal, even), 1, 0.01);
  EXPECT_NEAR(dot(walls[1].normal, even), 1, 0.01);
}

TEST(EvenStep, LeavesAStepThatDoes)
{
  const std::vector<FaceAtVertex> walls = { faceWith(leaning(10), 2.5), faceWith(leaning(-10), 2) };
  const Vector3 d = weightedNormal(walls);
  EXPECT_EQ(evenStep(walls, SideProjection({}), d), scaledStep(walls, d));
}

// No step rises alike above faces as steep as these.
TEST(EvenStep, SeesNoFaceMarkedlyWorse)
{
  const std::vector<FaceAtVertex> walls = { faceWith(leaning(80), 1), faceWith(leaning(-80), 1),
    faceWith({ 0, 0, 1 }, 4), faceWith(normalized({ 0, 0.5, 0.5 }), 2) };
  const SideProjection free({});
  const std::vector<Vector3> normals = normalsOf(walls);
  const Vector3 d = mostVisible(normals, free, weightedNormal(walls));
  const Vector3 even = evenStep(walls, free, d);
  EXPECT_GT(visibility(normals, normalized(even)), 0.95 * visibility(normals, d));
  EXPECT_LE(norm(even), 3);
}

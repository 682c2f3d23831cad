#include "Layers/FanPlanning.h"
#include "Layers/TensorCorner.h"

#include "Geometry/Angles.h"
#include "Mesh/Builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace ransmesh;

namespace
{
// Wall faces between a point at the origin and rim points around it, counterclockwise seen from the fluid,
// which lies on the side of the point above.
struct Wall
{
  TetMesh mesh;
  BoundaryStars stars;

  Wall(const std::vector<Vector3>& rim, const Vector3& above, bool closed = true)
    : mesh(meshOf(rim, above, closed))
    , stars(mesh)
  {
  }

  static TetMesh meshOf(const std::vector<Vector3>& rim, const Vector3& above, bool closed)
  {
    MeshData data;
    data.points = { { 0, 0, 0 }, above };
    data.points.insert(data.points.end(), rim.begin(), rim.end());
    const auto count = static_cast<Index>(rim.size());
    for (Index i = 0; i < (closed ? count : count - 1); ++i)
    {
      data.tetrahedra.push_back({ 0, 2 + i, 2 + (i + 1) % count, 1 });
    }
    const auto add = [&data](Index a, Index b, Index c, int patch)
    {
      data.triangles.push_back({ a, c, b }); // outward
      data.trianglePatch.push_back(patch);
    };
    for (const auto& t : data.tetrahedra)
    {
      add(0, t[1], t[2], 1);
      add(t[2], t[1], 1, 2);
    }
    if (!closed)
    {
      add(0, 1, 2, 2);
      add(1, 0, count + 1, 2);
    }
    TetMesh mesh;
    EXPECT_TRUE(buildTetMesh(data, mesh).ok());
    return mesh;
  }

  std::vector<FaceAtVertex> faces() const
  {
    std::vector<FaceAtVertex> faces;
    for (const Index b : stars.facesAt(0))
    {
      if (stars.seenFrom(0, b).patch == 1)
      {
        faces.push_back(stars.seenFrom(0, b));
      }
    }
    return faces;
  }
  FaceRing ring() const
  {
    FaceRing ring;
    EXPECT_TRUE(makeRing(faces(), ring));
    return ring;
  }
};

// A convex ridge along y, falling to both sides at the angle (degrees).
Wall ridge(double angle)
{
  const double s = std::sin(angle / DegreesOfRadian);
  const double c = std::cos(angle / DegreesOfRadian);
  return { { { c, 0, -s }, { 0, 1, 0 }, { -c, 0, -s }, { 0, -1, 0 } }, { 0, 0, 2 } };
}

// Edges down the axes' other halves: the corner of a cube.
Wall cubeCorner()
{
  return { { { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, -1 } }, { 0.2, 0.2, 0.2 } };
}

// A cone that points up; its flank falls at the angle.
Wall cone(double angle)
{
  std::vector<Vector3> rim;
  for (int i = 0; i < 16; ++i)
  {
    const double a = 2 * std::numbers::pi * i / 16;
    rim.push_back({ std::cos(a), std::sin(a), -std::tan(angle / DegreesOfRadian) });
  }
  return { rim, { 0, 0, 2 } };
}

struct Planned
{
  bool isFan;
  Fan fan;
  Vector3 main;

  // single: of one column that sees all faces, if there is one.
  explicit Planned(
    const Wall& wall, double normalAngle = 30, double fanAngle = 30, const Vector3& single = {})
  {
    FaceRing ring = wall.ring();
    fan.single = single;
    main = single;
    isFan = planFan({ 0, 0, 0 }, wall.mesh, ring, SideProjection({}),
      { normalAngle / DegreesOfRadian, fanAngle / DegreesOfRadian }, fan, main);
  }
};
} // namespace

TEST(FaceRing, PutsShuffledFacesInOrder)
{
  const Wall wall = cone(30);
  std::vector<FaceAtVertex> faces = wall.faces();
  std::mt19937 random(1);
  for (int i = 0; i < 10; ++i)
  {
    std::shuffle(faces.begin(), faces.end(), random);
    FaceRing ring;
    ASSERT_TRUE(makeRing(faces, ring));
    EXPECT_TRUE(ring.closed);
    for (std::size_t k = 0; k < ring.faces.size(); ++k)
    {
      EXPECT_EQ(ring.faces[k].vertex[2], ring.faces[(k + 1) % ring.faces.size()].vertex[1]);
    }
  }
  faces.erase(faces.begin() + 3);
  FaceRing open;
  ASSERT_TRUE(makeRing(faces, open));
  EXPECT_FALSE(open.closed);
  EXPECT_EQ(open.faces.size(), 15u);
  std::vector<FaceAtVertex> parts = open.faces;
  parts.erase(parts.begin() + 7);
  EXPECT_FALSE(makeRing(parts, open)) << "in two parts";
}

TEST(FanPlanning, SmoothPointsHaveNone)
{
  const Vector3 up{ 0, 0, 1 };
  EXPECT_FALSE(Planned(ridge(10), 30, 30, up).isFan);
  EXPECT_FALSE(Planned(cone(20), 30, 30, up).isFan);
  EXPECT_FALSE(Planned(ridge(-30), 30, 30, up).isFan); // concave
}

TEST(FanPlanning, ARidgeHasARowOfColumns)
{
  const Planned planned(ridge(45));
  ASSERT_TRUE(planned.isFan);
  EXPECT_FALSE(planned.fan.aroundMain);
  ASSERT_EQ(planned.fan.directions.size(), 3u);
  std::vector<Vector3> row = planned.fan.directions;
  row.push_back(planned.main);
  for (std::size_t i = 0; i + 1 < row.size(); ++i)
  {
    EXPECT_NEAR(degreesBetween(row[i], row[i + 1]), 30, 1e-9);
    EXPECT_NEAR(norm(row[i]), 1, 1e-12);
  }
  EXPECT_NEAR(degreesBetween(row.front(), row.back()), 90, 1e-9);
}

TEST(FanPlanning, ASharpEdgeTurnsAroundItsOutside)
{
  // The faces enclose 10 degrees: their normals are nearly opposite, the fan goes over the top.
  const Planned planned(ridge(85));
  ASSERT_TRUE(planned.isFan);
  EXPECT_EQ(planned.fan.directions.size(), 6u);
  for (const Vector3& d : planned.fan.directions)
  {
    EXPECT_GT(d.z, 0);
  }
}

TEST(FanPlanning, TheNumberOfColumnsFollowsTheFanAngle)
{
  EXPECT_EQ(Planned(ridge(45), 30, 45).fan.directions.size(), 2u);
  EXPECT_EQ(Planned(ridge(45), 30, 15).fan.directions.size(), 6u);
  EXPECT_EQ(Planned(ridge(45), 30, 180).fan.directions.size(), 1u);
  EXPECT_FALSE(Planned(ridge(45), 91, 30, { 0, 0, 1 }).isFan);
}

TEST(FanPlanning, ACornerHasAColumnAmidTheOthers)
{
  const Planned planned(cubeCorner());
  ASSERT_TRUE(planned.isFan);
  EXPECT_TRUE(planned.fan.aroundMain);
  EXPECT_TRUE(planned.fan.closed);
  EXPECT_EQ(planned.fan.directions.size(), 9u);
  const double third = 1 / std::sqrt(3.0);
  EXPECT_LT(distance(planned.main, { third, third, third }), 1e-3);
  const auto withFaces = std::count_if(
    planned.fan.walk.begin(), planned.fan.walk.end(), [](const FanStep& s) { return s.faces > 0; });
  EXPECT_EQ(withFaces, 3);
}

TEST(FanPlanning, ATipWithoutSharpEdgesIsParted)
{
  const Planned planned(cone(80));
  ASSERT_TRUE(planned.isFan);
  EXPECT_TRUE(planned.fan.aroundMain);
  EXPECT_GE(planned.fan.directions.size(), 12u);
  EXPECT_GT(planned.main.z, 0.9);
}

TEST(FanPlanning, ColumnsThatWouldCrossOverTheirEdgeMakeNone)
{
  // Beside a sharp edge the wall folds up: both groups' columns lean over the edge, past each other.
  const Vector3 single = normalized(Vector3{ 0.04, 0.97, 0.25 });
  const Wall wall({ { -0.58, 0.82, 1.33 }, { 0.46, 0, 0.63 }, { 0.34, -0.22, -0.55 }, { -0.49, 0, -0.61 },
                    { -1.08, 0.79, 0.61 }, { -0.49, -0.09, 0.37 } },
    single);
  const Planned planned(wall, 30, 30, single);
  EXPECT_FALSE(planned.isFan);
  EXPECT_EQ(planned.main, single);
  EXPECT_TRUE(planned.fan.walk.empty());
}

TEST(FanPlanning, AFanAtTheFootOfATrailingEdgeOpensOverItsEdges)
{
  // A fin on a hull; one column would hardly see the fin's sides.
  const std::vector<Vector3> rim{ { -1.94, 0.78, -0.30 }, { -1.07, 1.55, -0.19 }, { 0, 1.05, 0 },
    { -1.07, 1.56, 0.19 }, { -1.94, 0.78, 0.30 }, { -0.78, 0.13, 0.98 }, { -0.12, -0.35, 1.25 },
    { 0.63, -0.65, 1.07 }, { 1.17, -0.55, 0.01 }, { 0.70, -0.44, -0.63 }, { 0.09, -0.27, -0.93 },
    { -0.65, 0.08, -0.97 } };
  const Vector3 single = normalized(Vector3{ 0.99, -0.15, 0 });
  const Planned planned(Wall(rim, single), 30, 30, single);
  ASSERT_TRUE(planned.isFan);
  std::vector<Vector3> columns = planned.fan.directions;
  columns.push_back(planned.main);
  const std::vector<FanStep>& walk = planned.fan.walk;
  auto at = static_cast<std::size_t>(planned.fan.anchor[0]) - 2;
  for (std::size_t i = 0; i < walk.size(); ++i)
  {
    at = (at + static_cast<std::size_t>(walk[i].faces)) % rim.size();
    const Vector3 turn = cross(columns[walk[i].column], columns[walk[(i + 1) % walk.size()].column]);
    EXPECT_LT(dot(turn, rim[at]), 0) << "at step " << i;
  }
}

TEST(FanPlanning, AnEdgeThatEndsInAWallPartsItsFaces)
{
  // A fin of hardly any thickness stands on a floor; its free edge rises from the point.
  const Wall wall(
    { { 0, 0, 1 }, { 1, 1e-6, 0 }, { 0.5, 1, 0 }, { -1, 0, 0 }, { 0.5, -1, 0 }, { 1, -1e-6, 0 } },
    { -0.3, 0, 0.3 });
  const Planned planned(wall);
  ASSERT_TRUE(planned.isFan);
  EXPECT_FALSE(planned.fan.aroundMain);
  EXPECT_GT(planned.fan.directions[0].y * planned.main.y, -10);
  EXPECT_LT(planned.fan.directions[0].y * planned.main.y, 0);
  // Those between lead around the free edge, none along it.
  ASSERT_EQ(planned.fan.directions.size(), 6u);
  for (const Vector3& d : planned.fan.directions)
  {
    EXPECT_GT(degreesBetween(d, { 0, 0, 1 }), 30);
  }
  EXPECT_LT(degreesBetween(planned.fan.directions[3], { -1, 0, 1 }), 1e-3);
}

namespace
{
// A trough along y whose walls enclose the angle.
Wall trough(double angle)
{
  const double half = 0.5 * angle / DegreesOfRadian;
  const double s = std::sin(half);
  const double c = std::cos(half);
  return { { { s, 0, c }, { 0, 1, 0 }, { -s, 0, c }, { 0, -1, 0 } }, { 0, 0, 0.3 } };
}
} // namespace

TEST(TensorCorner, TwoWallsEachRiseWithinTheOther)
{
  for (const double angle : { 60.0, 90.0, 109.0 })
  {
    const Wall wall = trough(angle);
    FaceRing ring = wall.ring();
    TensorCorner corner;
    ASSERT_TRUE(findTensorCorner({ 0, 0, 0 }, wall.mesh, ring, {}, corner)) << angle;
    EXPECT_EQ(corner.walls, 2);
    for (int w = 0; w < 2; ++w)
    {
      EXPECT_NEAR(dot(corner.rise[w], corner.normal[w]), 1, 1e-12);
      EXPECT_NEAR(dot(corner.rise[w], corner.normal[1 - w]), 0, 1e-12);
      EXPECT_NEAR(corner.rise[w].y, 0, 1e-12);
      EXPECT_EQ(corner.wallOf(corner.normal[w]), w);
    }
    EXPECT_NEAR(norm(corner.diagonal()), 1 / std::sin(0.5 * angle / DegreesOfRadian), 1e-12);
  }
}

TEST(TensorCorner, ThreeWallsEachRiseInBothOthers)
{
  const Wall wall({ { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { 0.2, 0.2, 0.2 });
  FaceRing ring = wall.ring();
  TensorCorner corner;
  ASSERT_TRUE(findTensorCorner({ 0, 0, 0 }, wall.mesh, ring, {}, corner));
  EXPECT_EQ(corner.walls, 3);
  EXPECT_LT(distance(corner.diagonal(), { 1, 1, 1 }), 1e-12);
}

TEST(TensorCorner, FlatConvexAndAcutePlacesAreNone)
{
  for (const Wall& wall : { trough(170), trough(112), trough(20), trough(230), cubeCorner(), cone(20) })
  {
    FaceRing ring = wall.ring();
    TensorCorner corner;
    EXPECT_FALSE(findTensorCorner({ 0, 0, 0 }, wall.mesh, ring, {}, corner));
  }
}

TEST(TensorCorner, ARidgeMayEndInASide)
{
  // Half of a trough: its open end lies in the plane y = 0.
  const double h = std::sqrt(0.5);
  const Wall wall({ { h, 0, h }, { 0, 1, 0 }, { -h, 0, h } }, { 0, 0, 0.3 }, false);
  FaceRing ring = wall.ring();
  TensorCorner corner;
  EXPECT_FALSE(findTensorCorner({ 0, 0, 0 }, wall.mesh, ring, {}, corner));
  ASSERT_TRUE(findTensorCorner({ 0, 0, 0 }, wall.mesh, ring, { { 0, 1, 0 } }, corner));
  EXPECT_EQ(corner.rise[0].y, 0);
  const Vector3 skew = normalized({ 0.5 * h, 1, 0.5 * h }); // the walls lean against this side
  EXPECT_FALSE(findTensorCorner({ 0, 0, 0 }, wall.mesh, ring, { skew }, corner));
}

#include "Layers/SideWalk.h"

#include "Geometry/Distance.h"
#include "Mesh/Builder.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace ransmesh;
using namespace grid_mesh;

namespace
{
// Walks from the floor (ZLow) of a mapped cube.
struct Ground
{
  TetMesh mesh;
  BoundaryStars stars;
  SurfaceNormals normals;

  explicit Ground(const std::function<Vector3(const Vector3&)>& map, const PatchOf& patchOf = {})
    : mesh(build({ 10, 10, 10, map }, patchOf))
    , stars(mesh)
    , normals(mesh, stars, std::vector<char>(10, 1))
  {
  }
  static TetMesh build(const Grid& grid, const PatchOf& patchOf)
  {
    TetMesh mesh;
    EXPECT_TRUE(buildTetMesh(make(grid, patchOf), mesh).ok());
    return mesh;
  }

  SideWay walk(
    const Vector3& from, std::array<int, 2> sides, double reach, Vector3 direction = { 0, 0, 1 }) const
  {
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
    {
      if (distance(mesh.point(static_cast<Index>(v)), from) < 1e-9)
      {
        const SideStart start{ static_cast<Index>(v), sides, direction, { 0, 0, 1 } };
        return SideWalk(mesh, stars, normals).follow(start, reach);
      }
    }
    throw std::logic_error("no vertex there");
  }

  double distanceToPatch(const Vector3& x, int patch) const
  {
    double least = 1e300;
    for (std::size_t b = 0; b < mesh.boundarySlots(); ++b)
    {
      const auto v = mesh.boundaryVertices(static_cast<Index>(b));
      const double d = distanceToTriangle(x, mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]));
      least = mesh.boundaryFace(static_cast<Index>(b)).patch == patch ? std::min(least, d) : least;
    }
    return least;
  }

  void expectOnPatch(const SidePath& path, int patch, double top) const
  {
    for (int i = 0; i <= 50; ++i)
    {
      const double h = top * i / 50;
      EXPECT_LT(distanceToPatch(path.at(h), patch), 1e-14) << h;
      EXPECT_NEAR(path.heightOf(path.at(h)), h, 1e-14);
    }
  }
};

// The side XLow becomes a part of a sphere, a cylinder lying along y, or a cone, for x from 0 to 1.
Vector3 sphere(const Vector3& p)
{
  return { p.x + (1 - p.x) * (2 - std::sqrt(4 - p.z * p.z - p.y * p.y)), p.y, p.z };
}
Vector3 cylinder(const Vector3& p)
{
  return { p.x + (1 - p.x) * (2 - std::sqrt(4 - p.z * p.z)), p.y, p.z };
}
Vector3 cone(const Vector3& p)
{
  const double radius = 3 - 0.5 * p.z;
  return { p.x + (1 - p.x) * (3 - std::sqrt(radius * radius - p.y * p.y)), p.y, p.z };
}
} // namespace

TEST(SideWalk, AWayInAPlaneIsStraight)
{
  const Ground ground(turned);
  const Vector3 up = turned({ 0, 0, 1 });
  const Vector3 foot = turned({ 0, 0.5, 0 });
  for (std::size_t v = 0; v < ground.mesh.vertexCount(); ++v)
  {
    if (distance(ground.mesh.point(static_cast<Index>(v)), foot) < 1e-9)
    {
      const SideStart start{ static_cast<Index>(v), { XLow, 0 }, up, up };
      const SideWay way = SideWalk(ground.mesh, ground.stars, ground.normals).follow(start, 0.5);
      EXPECT_EQ(way.end, WalkEnd::Reached);
      EXPECT_LT(distance(way.path.at(0.45), foot + 0.45 * up), 1e-14);
    }
  }
}

TEST(SideWalk, StaysOnTheTrianglesOfCurvedPatches)
{
  for (const auto& map : { sphere, cylinder, cone })
  {
    const Ground ground(map);
    const SideWay way = ground.walk(map({ 0, 0.5, 0 }), { XLow, 0 }, 0.6);
    ASSERT_EQ(way.end, WalkEnd::Reached);
    ground.expectOnPatch(way.path, XLow, 0.6);
    for (int i = 0; i <= 6; ++i)
    {
      // In the plane of the direction and the normal, and near the true surface.
      const Vector3 x = way.path.at(0.1 * i);
      const Vector3 normal = way.path.normalsAt(0.1 * i)[0];
      EXPECT_GT(dot(normal, normalized(map({ 1e-6, x.y, x.z }) - map({ 0, x.y, x.z }))), 0.6);
      EXPECT_LT(distance(x, map({ 0, x.y, x.z })), 0.004);
    }
  }
}

TEST(SideWalk, FollowsTheRidgeOfTwoSides)
{
  const auto map = [](const Vector3& p)
  {
    const Vector3 q = sphere(p);
    return Vector3{ q.x, p.y + (1 - p.y) * 0.4 * p.z * p.z, p.z };
  };
  const Ground ground(map);
  const SideWay way = ground.walk(map({ 0, 0, 0 }), { XLow, YLow }, 0.6);
  ASSERT_EQ(way.end, WalkEnd::Reached);
  ground.expectOnPatch(way.path, XLow, 0.6);
  ground.expectOnPatch(way.path, YLow, 0.6);
  EXPECT_GT(way.path.normalsAt(0.1)[0].x, 0.9);
  EXPECT_GT(way.path.normalsAt(0.1)[1].y, 0.9);
}

TEST(SideWalk, EndsWhereTheSideEnds)
{
  const Ground ground({});
  const SideWay across = ground.walk({ 0, 0.5, 0 }, { XLow, 0 }, 3);
  EXPECT_EQ(across.end, WalkEnd::Border);
  EXPECT_NEAR(across.path.top(), 1, 1e-14);
  const SideWay alongRidge = ground.walk({ 0, 0, 0 }, { XLow, YLow }, 3);
  EXPECT_EQ(alongRidge.end, WalkEnd::Border);
  EXPECT_NEAR(alongRidge.path.top(), 1, 1e-14);
}

TEST(SideWalk, TellsThatASideGoesOnUnderAnotherName)
{
  const auto upper = [](Side side, const Vector3& middle)
  { return side == XLow && middle.z > 0.5 ? 7 : static_cast<int>(side); };
  const SideWay way = Ground({}, upper).walk({ 0, 0.5, 0 }, { XLow, 0 }, 3);
  EXPECT_EQ(way.end, WalkEnd::Continued);
  EXPECT_NEAR(way.path.top(), 0.5, 1e-14);
}

TEST(SideWalk, EndsAtARidgeWithinThePatch)
{
  const auto roof = [](const Vector3& p) {
    return Vector3{ p.x + (1 - p.x) * std::max(0.0, p.z - 0.5), p.y, p.z };
  };
  const SideWay way = Ground(roof).walk({ 0, 0.5, 0 }, { XLow, 0 }, 3);
  EXPECT_EQ(way.end, WalkEnd::Border);
  EXPECT_NEAR(way.path.top(), 0.5, 1e-14);
}

TEST(SideWalk, EndsWhereTheSideBendsAway)
{
  const auto dome = [](const Vector3& p)
  {
    const double angle = M_PI / 2 * p.z;
    const double radius = 2 - p.x;
    return Vector3{ 2 - radius * std::cos(angle), p.y, radius * std::sin(angle) };
  };
  const SideWay way = Ground(dome).walk({ 0, 0.5, 0 }, { XLow, 0 }, 3);
  EXPECT_EQ(way.end, WalkEnd::Bent);
  EXPECT_NEAR(way.path.top(), 2 * std::sin(M_PI / 4), 0.2);
}

TEST(SideWalk, FindsNoWayOffTheSide)
{
  EXPECT_EQ(Ground({}).walk({ 0, 0.5, 0 }, { XLow, 0 }, 1, { 0, 0, -1 }).end, WalkEnd::NoWay);
  EXPECT_EQ(Ground({}).walk({ 0, 0, 0 }, { XLow, YHigh }, 1).end, WalkEnd::NoWay);
}

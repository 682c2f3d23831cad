#include "Geometry/Distance.h"
#include "Insertion/EnrichmentChecks.h"
#include "Mesh/Validation.h"
#include "Support/GridMesh.h"
#include "Support/Invariants.h"

#include <cmath>

using namespace enrichment_checks;
using namespace grid_mesh;

namespace
{
// Sides that lean and bend as they rise from the floor (ZLow), and along it.
Vector3 bentSides(const Vector3& p)
{
  const double bulge = 0.25 * std::cos(1.2 * p.z);
  return { p.x - (1 - p.x) * bulge * (1 + 0.5 * std::sin(2 * p.y)), p.y + p.y * bulge * (1 + 0.3 * p.x),
    p.z };
}

// A pipe whose inlet (YLow) is a spherical cap.
Vector3 cappedPipe(const Vector3& p)
{
  const double angle = M_PI / 2 * p.x;
  const double radius = 0.4 + 0.6 * p.z;
  const double cap = std::sqrt(2 - radius * radius) - 1;
  return { radius * std::sin(angle), 2 * p.y - (1 - p.y) * cap, radius * std::cos(angle) };
}

struct SideMeasures
{
  double farthest = 0; // of its vertices from the patch as it was
  double turn = 0;     // largest between a triangle and the nearest one of the patch as it was, degrees
};

SideMeasures compareSide(const MeshData& before, const MeshData& after, int patch)
{
  const auto corners = [](const MeshData& m, std::size_t t)
  {
    return std::array{ m.points[m.triangles[t][0]], m.points[m.triangles[t][1]],
      m.points[m.triangles[t][2]] };
  };
  const auto normal = [](const std::array<Vector3, 3>& p)
  { return normalized(cross(p[1] - p[0], p[2] - p[0])); };
  const auto nearest = [&](const Vector3& x, Vector3& direction)
  {
    double least = 1e300;
    for (std::size_t i = 0; i < before.triangles.size(); ++i)
    {
      const auto p = corners(before, i);
      const double d = distanceToTriangle(x, p[0], p[1], p[2]);
      if (before.trianglePatch[i] == patch && d < least)
      {
        least = d;
        direction = normal(p);
      }
    }
    return least;
  };
  SideMeasures measures;
  Vector3 direction;
  for (std::size_t i = 0; i < after.triangles.size(); ++i)
  {
    if (after.trianglePatch[i] != patch)
    {
      continue;
    }
    const auto p = corners(after, i);
    for (const Vector3& x : p)
    {
      measures.farthest = std::max(measures.farthest, nearest(x, direction));
    }
    nearest((1.0 / 3) * (p[0] + p[1] + p[2]), direction);
    const double cosine = std::min(1.0, dot(direction, normal(p)));
    measures.turn = std::max(measures.turn, std::acos(cosine) * 180 / M_PI);
  }
  return measures;
}

EnrichedMesh enrichCurved(const MeshData& mesh, const LayerPlan& plan, double angle = 10)
{
  PatchTable table = patches(PatchType::Symmetry);
  EnrichmentOptions options;
  options.maximumSurfaceAngle = angle;
  EnrichedMesh enriched;
  const Outcome outcome = enrich(mesh, table, plan, options, {}, enriched);
  EXPECT_TRUE(outcome.ok()) << outcome.message;
  EXPECT_TRUE(findFaults(enriched.mesh).none()) << findFaults(enriched.mesh).text();
  return enriched;
}

void expectSidesKept(const MeshData& before, const EnrichedMesh& after, std::initializer_list<int> sides)
{
  for (const int side : sides)
  {
    const SideMeasures measures = compareSide(before, after.mesh, side);
    EXPECT_LT(measures.farthest, 1e-12) << "side " << side;
    EXPECT_LT(measures.turn, 20) << "side " << side;
  }
  const double volume = totalVolume(before);
  EXPECT_NEAR(totalVolume(after.mesh), volume, 5e-3 * volume);
}
} // namespace

TEST(CurvedSides, ThinLayersAreComplete)
{
  const MeshData mesh = make({ 8, 8, 8, bentSides });
  const auto enriched = enrichCurved(mesh, planFor(7, { ZLow }, 1e-5, 25));
  expectCompleteLayers(mesh, enriched, ZLow, 25);
  expectSidesKept(mesh, enriched, { XLow, XHigh, YLow, YHigh });
}

TEST(CurvedSides, LayersThickerThanTheSurfaceSizeFollowThem)
{
  const MeshData mesh = make({ 10, 10, 10, bentSides });
  const auto enriched = enrichCurved(mesh, planFor(7, { ZLow }, 1e-3, 20));
  EXPECT_GT(enriched.report.pointsInserted, 0.98 * static_cast<double>(enriched.report.pointsRequested));
  expectSidesKept(mesh, enriched, { XLow, XHigh, YLow, YHigh });
}

TEST(CurvedSides, APipeBehindASphericalCapIsComplete)
{
  const MeshData mesh = make({ 14, 10, 8, cappedPipe });
  for (const int wall : { ZLow, ZHigh })
  {
    const auto enriched = enrichCurved(mesh, planFor(7, { wall }, 1e-4, 20));
    EXPECT_EQ(enriched.report.pointsInserted, enriched.report.columns * 20);
    expectSidesKept(mesh, enriched, { XLow, XHigh, YLow, YHigh });
  }
}

TEST(CurvedSides, AFanStandsInThem)
{
  // The floor is a roof whose ridge along x ends in the bent sides.
  const auto roof = [](const Vector3& p) {
    return bentSides({ p.x, p.y, p.z - (1 - p.z) * 1.2 * std::fabs(p.y - 0.5) });
  };
  const MeshData mesh = make({ 8, 8, 8, roof });
  const auto enriched = enrichCurved(mesh, planFor(7, { ZLow }, 1e-4, 20));
  EXPECT_EQ(enriched.report.fans.planned, 9u * 3u);
  EXPECT_EQ(enriched.report.fans.opened, enriched.report.fans.planned);
  EXPECT_EQ(enriched.report.pointsInserted, enriched.report.pointsRequested);
  expectSidesKept(mesh, enriched, { XLow, XHigh, YLow, YHigh });
}

TEST(CurvedSides, HeightsAreAboveTheWall)
{
  const MeshData mesh = make({ 8, 8, 8, bentSides });
  const LayerPlan plan = planFor(7, { ZLow }, 1e-3, 12);
  const auto enriched = enrichCurved(mesh, plan);
  const LayerHeights heights(plan[ZLow]);
  std::map<Index, int> level;
  for (std::size_t i = 0; i < enriched.mesh.points.size(); ++i)
  {
    if (enriched.column[i] != None)
    {
      EXPECT_NEAR(enriched.mesh.points[i].z, heights.height(level[enriched.column[i]]++), 1e-12);
    }
  }
}

TEST(CurvedSides, TheMaximumSurfaceAngleTakesEffect)
{
  const MeshData mesh = make({ 8, 8, 8, bentSides });
  const LayerPlan plan = planFor(7, { ZLow }, 1e-3, 20);
  const auto strict = enrichCurved(mesh, plan, 0);
  const auto usual = enrichCurved(mesh, plan, 10);
  EXPECT_LT(strict.report.pointsInserted, usual.report.pointsInserted);
}

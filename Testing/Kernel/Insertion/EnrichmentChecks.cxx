#include "Insertion/EnrichmentChecks.h"

#include "Geometry/TetrahedronMeasures.h"
#include "Mesh/Validation.h"
#include "Support/Invariants.h"

#include <algorithm>
#include <array>

namespace enrichment_checks
{
LayerPlan planFor(std::size_t patches, const std::set<int>& walls, double firstHeight, int layers)
{
  LayerPlan plan(patches);
  for (const int wall : walls)
  {
    plan[wall].firstHeight = firstHeight;
    plan[wall].numberOfLayers = layers;
  }
  return plan;
}

namespace
{
void checkArrays(const EnrichedMesh& enriched)
{
  EXPECT_EQ(enriched.layer.size(), enriched.mesh.tetrahedra.size());
  const std::vector<Index> prismOf = ransmesh::numberPrisms(enriched);
  EXPECT_EQ(prismOf.size(), enriched.mesh.tetrahedra.size());
  EXPECT_EQ(enriched.column.size(), enriched.mesh.points.size());
  EXPECT_EQ(enriched.origin.size(), enriched.mesh.points.size());
  std::map<Index, std::set<int>> layersOfPrism;
  std::map<Index, int> tetsOfPrism;
  std::size_t layerTets = 0;
  for (std::size_t t = 0; t < enriched.layer.size(); ++t)
  {
    EXPECT_EQ(enriched.layer[t] > 0, prismOf[t] != None);
    layerTets += enriched.layer[t] > 0;
    if (prismOf[t] != None)
    {
      ++tetsOfPrism[prismOf[t]];
      layersOfPrism[prismOf[t]].insert(enriched.layer[t]);
    }
  }
  EXPECT_EQ(layerTets, enriched.report.layerTets);
  for (const auto& [prism, count] : tetsOfPrism)
  {
    EXPECT_LE(count, 3) << "prism " << prism;
    EXPECT_EQ(layersOfPrism[prism].size(), 1u) << "prism " << prism;
  }
}

void checkCounts(const EnrichedMesh& enriched)
{
  std::size_t achieved = 0;
  for (const WallPoint& point : enriched.wallPoints)
  {
    achieved += static_cast<std::size_t>(point.layersAchieved);
    EXPECT_LE(point.layersAchieved, point.layersAsked);
    EXPECT_EQ(point.layersAchieved == point.layersAsked, point.reason == StopReason::Complete);
  }
  // Fans and tensor-product corners have more points than the columns of their roots.
  EXPECT_LE(achieved, enriched.report.pointsInserted);
  EXPECT_LE(enriched.report.pointsInserted, enriched.report.pointsRequested);
}
} // namespace

EnrichedMesh enrichAndCheck(
  const MeshData& mesh, const PatchTable& patches, const LayerPlan& plan, double tolerance)
{
  EnrichedMesh enriched;
  EXPECT_TRUE(findFaults(mesh).none()) << findFaults(mesh).text();
  const Outcome outcome = enrich(mesh, patches, plan, {}, {}, enriched);
  EXPECT_TRUE(outcome.ok()) << outcome.message;
  invariants::expectKept(mesh, enriched.mesh, tolerance);
  checkArrays(enriched);
  checkCounts(enriched);
  return enriched;
}

double largestLayerAngle(const EnrichedMesh& enriched)
{
  double largest = 0;
  const auto& p = enriched.mesh.points;
  for (std::size_t t = 0; t < enriched.layer.size(); ++t)
  {
    const auto& v = enriched.mesh.tetrahedra[t];
    largest = enriched.layer[t] > 0 ? std::max(largest, largestDihedral(p[v[0]], p[v[1]], p[v[2]], p[v[3]]))
                                    : largest;
  }
  return largest;
}

void expectCompleteLayers(const MeshData& input, const EnrichedMesh& enriched, int wall, int layers)
{
  const MeshData& mesh = enriched.mesh;
  EXPECT_EQ(enriched.report.pointsInserted, enriched.report.columns * static_cast<std::size_t>(layers));
  // The points of each column, from the wall outward.
  std::map<Index, std::vector<Index>> column;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    if (enriched.column[i] != None)
    {
      column[enriched.column[i]].push_back(static_cast<Index>(i));
    }
  }
  std::set<std::array<Index, 3>> faces;
  for (const auto& t : mesh.tetrahedra)
  {
    for (int skip = 0; skip < 4; ++skip)
    {
      std::array<Index, 3> face = { t[(skip + 1) % 4], t[(skip + 2) % 4], t[(skip + 3) % 4] };
      std::sort(face.begin(), face.end());
      faces.insert(face);
    }
  }
  for (std::size_t i = 0; i < input.triangles.size(); ++i)
  {
    if (input.trianglePatch[i] != wall)
    {
      continue;
    }
    for (int level = 0; level <= layers; ++level)
    {
      std::array<Index, 3> face;
      for (int j = 0; j < 3; ++j)
      {
        face[j] = column.at(enriched.column[input.triangles[i][j]])[level];
      }
      std::sort(face.begin(), face.end());
      EXPECT_TRUE(faces.count(face)) << "triangle " << i << ", level " << level;
    }
  }
}
} // namespace enrichment_checks

#include "Mesh/Collapse.h"

#include "Boundary/Classification.h"
#include "Improvement/VertexLink.h"
#include "Mesh/Star.h"
#include "Support/GridMesh.h"
#include "Support/Invariants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace
{
using namespace ransmesh;

// The tetrahedra by their vertices, the first one smallest, parity kept.
std::set<std::array<Index, 4>> tetrahedraOf(const TetMesh& mesh)
{
  std::set<std::array<Index, 4>> found;
  for (std::size_t t = 0; t < mesh.tetSlots(); ++t)
  {
    auto v = mesh.tet(static_cast<Index>(t)).vertex;
    if (mesh.tet(static_cast<Index>(t)).isAlive())
    {
      const auto first = std::min_element(v.begin(), v.end()) - v.begin();
      constexpr int even[4][4] = { { 0, 1, 2, 3 }, { 1, 0, 3, 2 }, { 2, 3, 0, 1 }, { 3, 2, 1, 0 } };
      std::array<Index, 4> w;
      std::transform(even[first], even[first] + 4, w.begin(), [&](int i) { return v[i]; });
      while (w[1] != std::min({ w[1], w[2], w[3] }))
      {
        std::rotate(w.begin() + 1, w.begin() + 2, w.end());
      }
      found.insert(w);
    }
  }
  return found;
}

// Collapses every vertex of a box that can go, inside and on the plane sides, and compares with the star.
TEST(Collapse, DoesWhatTheStarDoes)
{
  const MeshData data = grid_mesh::make({ 4, 4, 4, {}, 0.2, 3 });
  TetMesh mesh = invariants::build(data);
  const Classification c = classify(mesh, grid_mesh::patches(PatchType::Symmetry));
  VertexLink link(mesh);
  std::set<VertexKind> kinds;
  std::size_t refused = 0;
  for (Index v = 0; v < static_cast<Index>(mesh.vertexCount()); ++v)
  {
    link.turnTo(v);
    for (int end = 0; end < static_cast<int>(link.ends().size()); ++end)
    {
      const Index u = link.ends()[end];
      const auto own = c.patchesAt(v);
      const auto others = c.patchesAt(u);
      TetMesh starred = mesh;
      Cavity cavity{ { link.ball().begin(), link.ball().end() }, {} };
      for (const Index t : link.ball())
      {
        for (int f = 0; f < 4; ++f)
        {
          if (mesh.tet(t).vertex[f] != v && isBoundary(mesh.tet(t).neighbour[f]))
          {
            cavity.starredFaces.push_back(boundaryFaceOf(mesh.tet(t).neighbour[f]));
          }
        }
      }
      Star star(starred);
      const StarVerdict verdict = star.check(cavity, u);
      const bool stays = std::includes(others.begin(), others.end(), own.begin(), own.end());
      if (!stays || verdict == StarVerdict::EdgeNotManifold)
      {
        continue;
      }
      const bool possible = canCollapse(mesh, link.ball(), v, u) && link.allPositiveFrom(end);
      EXPECT_EQ(possible, verdict == StarVerdict::Possible);
      refused += !possible;
      if (possible && c.kind[v] != VertexKind::Corner)
      {
        kinds.insert(c.kind[v]);
        star.apply();
        collapse(mesh, link.ball(), v, u);
        EXPECT_EQ(tetrahedraOf(mesh), tetrahedraOf(starred));
        break;
      }
    }
  }
  invariants::expectValid(mesh);
  invariants::expectKept(data, toMeshData(mesh));
  EXPECT_EQ(kinds.size(), 3u) << "in the volume, on surfaces, on ridges";
  EXPECT_GT(refused, 10u);
}
} // namespace

#include "Support/Invariants.h"

#include "Mesh/Builder.h"
#include "Mesh/Validation.h"

#include <gtest/gtest.h>

namespace invariants
{
using namespace ransmesh;

std::map<int, double> patchAreas(const MeshData& mesh)
{
  std::map<int, double> areas;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const auto& t = mesh.triangles[i];
    const Vector3& a = mesh.points[t[0]];
    areas[mesh.trianglePatch[i]] += norm(cross(mesh.points[t[1]] - a, mesh.points[t[2]] - a)) / 2;
  }
  return areas;
}

void expectKept(const MeshData& before, const MeshData& after, double tolerance)
{
  const MeshFaults faults = findFaults(after);
  EXPECT_TRUE(faults.none()) << faults.text();
  const double volume = totalVolume(before);
  EXPECT_NEAR(totalVolume(after), volume, tolerance * volume);
  const auto areas = patchAreas(after);
  for (const auto& [patch, area] : patchAreas(before))
  {
    ASSERT_TRUE(areas.count(patch)) << "patch " << patch;
    EXPECT_NEAR(areas.at(patch), area, tolerance * area) << "patch " << patch;
  }
}

void expectValid(const TetMesh& mesh)
{
  const MeshFaults faults = findFaults(mesh);
  EXPECT_TRUE(faults.none()) << faults.text();
}

TetMesh build(const MeshData& data)
{
  TetMesh mesh;
  const Outcome outcome = buildTetMesh(data, mesh);
  EXPECT_TRUE(outcome.ok()) << outcome.message;
  return mesh;
}
} // namespace invariants

// Surfaces of needles and slivers: the mesh is valid, and the layers are whole but for single points.
#include "Bodies/Blocks.h"
#include "Bodies/Rounds.h"
#include "Vtk/BodyPolyData.h"
#include "Vtk/ChainRun.h"

#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <functional>
#include <ostream>
#include <random>
#include <string>

namespace
{
using bodies::Body;
using ransmesh::Index;
using ransmesh::Vector3;

// Cuts each so many-th triangle in three, at a point so near to one of its edges, as a share of its height.
Body withSlivers(Body body, std::size_t step, double share)
{
  std::mt19937 random(7);
  auto& s = body.surface;
  const std::size_t count = s.triangles.size();
  for (std::size_t t = 0; t < count; t += step)
  {
    const auto [a, b, c] = s.triangles[t];
    const double along = 0.2 + 0.6 * (random() / 4294967296.0);
    const Vector3 foot = s.points[a] + along * (s.points[b] - s.points[a]);
    const auto p = static_cast<Index>(s.points.size());
    s.points.push_back(foot + share * (s.points[c] - foot));
    s.triangles[t] = { a, b, p };
    s.triangles.push_back({ b, c, p });
    s.triangles.push_back({ c, a, p });
    s.patch.insert(s.patch.end(), 2, s.patch[t]);
  }
  return body;
}

Body stretched(Body body, const Vector3& by)
{
  for (Vector3& p : body.surface.points)
  {
    p = { by.x * p.x, by.y * p.y, by.z * p.z };
  }
  return body;
}

struct Poor
{
  std::string name;
  std::function<Body()> make;
};

void PrintTo(const Poor& poor, std::ostream* out)
{
  *out << poor.name;
}

const Poor all[] = {
  { "slivers", [] { return withSlivers(bodies::sphereOfSize(0.12), 10, 1e-4); } },
  { "needles", [] { return withSlivers(bodies::sphereOfSize(0.12), 10, 1e-6); } },
  { "stretchedBall",
    [] {
      return stretched(bodies::sphereOfSize(0.12), { 100, 1, 1 });
    } },
  { "flattenedBall",
    [] {
      return stretched(bodies::sphereOfSize(0.12), { 1, 1, 0.01 });
    } },
  { "stretchedCube",
    [] {
      return stretched(bodies::cube(0.2), { 100, 10, 1 });
    } },
};

class PoorSurfaces : public testing::TestWithParam<Poor>
{
};
} // namespace

TEST_P(PoorSurfaces, KeepTheirLayers)
{
  const Body body = GetParam().make();
  chain_run::ChainOptions options;
  options.farField = true;
  options.firstHeight = 1e-6;
  const chain_run::ChainResult result = chain_run::runChain(toPolyData(body), options);
  EXPECT_EQ(result.faults, "");
  EXPECT_GE(static_cast<double>(result.fullColumns), 0.995 * static_cast<double>(result.columns));
  EXPECT_GE(static_cast<double>(result.inserted), 0.9999 * static_cast<double>(result.requested));
}

INSTANTIATE_TEST_SUITE_P(Property, PoorSurfaces, testing::ValuesIn(all),
  [](const testing::TestParamInfo<Poor>& poor) { return poor.param.name; });

// Every case that the layers are judged by, with coarse triangles: the mesh is valid, and the layers are as good as
// the case wants them or, where that is not reached yet, as good as they were.
#include "Bodies/Cases.h"
#include "Vtk/ChainRun.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <ostream>

namespace bodies
{
// What the test calls a case.
static void PrintTo(const Case& c, std::ostream* out)
{
  *out << c.name;
}
} // namespace bodies

namespace
{
using bodies::Case;
using bodies::Goals;

// Where a case falls short of its goals, what it does reach.
const std::map<std::string, Goals> reached = {
  { "capped-pipe-thick1", { 0.9995, 0.995, 1e-3, 2e-4 } },
  { "cylinder-floor", { 0.99999, 0.98, 1e-3, 2e-4 } },
};

Goals goalsOf(const Case& c)
{
  const auto found = reached.find(c.name);
  return found != reached.end() ? found->second : c.goals;
}

double share(vtkIdType part, vtkIdType whole)
{
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

// Columns that have all layers, or as many as a gap leaves.
double shareOfFullColumns(const chain_run::ChainResult& result)
{
  vtkIdType full = 0;
  for (const auto& [reason, count] : result.stopReasons)
  {
    full += reason == "none" || reason == "gap" ? count : 0;
  }
  return share(full, result.columns);
}

class Cases : public testing::TestWithParam<Case>
{
};

std::string testName(const testing::TestParamInfo<Case>& info)
{
  std::string name = info.param.name;
  std::replace_if(
    name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
  return name;
}
} // namespace

TEST_P(Cases, AreValidAndReachTheirGoals)
{
  const Case& c = GetParam();
  const bodies::Layers layers = c.layers(c.testSize);
  const bodies::Body body = c.make(c.testSize, layers);
  chain_run::ChainOptions options;
  options.firstHeight = layers.firstHeight;
  options.growth = layers.growth;
  options.layers = layers.number;
  const chain_run::ChainResult result = runChain(body, options);
  EXPECT_EQ(result.faults, "");
  EXPECT_LT(result.volumeChange, c.volumeChange);
  const Goals goals = goalsOf(c);
  EXPECT_GE(share(result.inserted, result.requested), goals.inserted);
  EXPECT_GE(shareOfFullColumns(result), goals.fullColumns);
  EXPECT_LE(share(result.over175, result.layerTetrahedra), goals.over175);
  EXPECT_LE(share(result.over179, result.layerTetrahedra), goals.over179);
}

INSTANTIATE_TEST_SUITE_P(Layers, Cases, testing::ValuesIn(bodies::allCases()), testName);

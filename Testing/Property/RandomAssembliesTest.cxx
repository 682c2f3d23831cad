// Random bodies of the hard kinds through the chain: the mesh is always valid. For long runs:
//   RANSMESHING_RANDOM_BODIES=5000 RANSMESHING_FIRST_SEED=1000
//     RANSMeshingPropertyTests --gtest_filter=*RandomAssemblies*
#include "Bodies/RandomAssemblies.h"
#include "RandomRun.h"
#include "Vtk/BodyPolyData.h"

#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <sstream>

namespace
{
using namespace random_run;

chain_run::ChainOptions optionsFor(const bodies::RandomAssembly& random)
{
  chain_run::ChainOptions options;
  options.firstHeight = random.layers.firstHeight;
  options.growth = random.layers.growth;
  options.layers = random.layers.number;
  options.walls = random.walls;
  options.symmetryPlace = random.symmetryPlace;
  for (const bodies::PatchLayers& p : random.patchLayers)
  {
    options.patchLayers.push_back({ p.patch, p.firstHeight * random.layers.firstHeight, p.growth, p.number });
  }
  return options;
}

std::string describe(const bodies::RandomAssembly& random)
{
  std::ostringstream text;
  text.precision(17);
  text << "edges " << random.size << ", first height " << random.layers.firstHeight << ", growth "
       << random.layers.growth << ", layers " << random.layers.number
       << (random.body.farField ? ", far field" : "");
  if (random.symmetryPlace)
  {
    text << ", symmetry at z = " << *random.symmetryPlace;
  }
  for (const bodies::PatchLayers& p : random.patchLayers)
  {
    text << "; " << p.patch << ": " << p.firstHeight << " times, growth " << p.growth << ", layers "
         << p.number;
  }
  return text.str();
}

// Whether there is such a body.
bool isMeshed(std::uint32_t seed, VolumeChanges& largest)
{
  const bodies::RandomAssembly random = bodies::randomAssembly(seed);
  if (random.body.surface.triangles.empty())
  {
    return false;
  }
  // Small bodies of few, curved triangles, whose sides of any type are curved, too.
  constexpr Drifts allowed = { 2e-2, 5e-3 };
  const auto run = [&] { return chain_run::runChain(random.body, optionsFor(random)); };
  if (const std::string fault = findFault(run, toPolyData(random.body), random.size, allowed, largest);
      !fault.empty())
  {
    ADD_FAILURE() << "seed " << seed << ": " << fault << "\n" << describe(random);
  }
  return true;
}
} // namespace

// Stacks of columns between walls of unequal heights, beside grids: their columns rose in another order than the
// grids'.
TEST(Property, AssembliesThatOnceFailedGiveValidMeshes)
{
  VolumeChanges largest;
  for (const std::uint32_t seed : { 111066U, 111084U, 111093U })
  {
    EXPECT_TRUE(isMeshed(seed, largest));
  }
}

TEST(Property, RandomAssembliesGiveValidMeshes)
{
  runSeeds(12, isMeshed);
}

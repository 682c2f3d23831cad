// Random bodies through the chain: the mesh is always valid. For long runs:
//   RANSMESHING_RANDOM_BODIES=5000 RANSMESHING_FIRST_SEED=1000 RANSMeshingPropertyTests
// A body that fails is written to a file, and what repeats it by ransmesh-cases is printed: seeds give other bodies
// whenever what makes them changes.
#include "Bodies/RandomBodies.h"
#include "RandomRun.h"
#include "Triangles/SurfaceIntersections.h"
#include "Vtk/BodyPolyData.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <gtest/gtest.h>

#include <random>
#include <sstream>

namespace
{
using namespace random_run;

// Layers of 0.03 to 3 edge lengths; the fluid is around the body or in it.
chain_run::ChainOptions randomOptions(std::uint32_t seed, double size)
{
  std::mt19937 random(seed + 1000000);
  const auto between = [&random](double low, double high)
  { return low + (high - low) * (random() / 4294967296.0); };
  chain_run::ChainOptions options;
  options.farField = random() % 2 == 0;
  options.layers = static_cast<int>(between(3, 30));
  options.growth = between(1, 1.5);
  double heights = 0;
  for (int i = 0; i < options.layers; ++i)
  {
    heights += std::pow(options.growth, i);
  }
  options.firstHeight = size * std::pow(10, between(-1.5, 0.5)) / heights;
  return options;
}

// What repeats the failure, its surface kept in a file.
std::string howToRepeat(std::uint32_t seed, vtkPolyData* surface, const chain_run::ChainOptions& options)
{
  const std::string path = testing::TempDir() + "random-body-" + std::to_string(seed) + ".vtp";
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(surface);
  writer->SetFileName(path.c_str());
  writer->SetDataModeToBinary();
  writer->Write();
  std::ostringstream text;
  text.precision(17);
  text << "ransmesh-cases " << path << " --h0 " << options.firstHeight << " --growth " << options.growth
       << " --layers " << options.layers << (options.farField ? " --far-field" : "");
  return text.str();
}

// Whether there is such a body.
bool isMeshed(std::uint32_t seed, VolumeChanges& largest)
{
  const bodies::RandomBody random = bodies::randomBody(seed);
  if (random.body.surface.triangles.empty())
  {
    return false;
  }
  const chain_run::ChainOptions options = randomOptions(seed, random.size);
  const vtkSmartPointer<vtkPolyData> surface = toPolyData(random.body);
  const auto run = [&] { return chain_run::runChain(surface, options); };
  if (const std::string fault = findFault(run, surface, random.size, { 5e-3, 1e-3 }, largest); !fault.empty())
  {
    ADD_FAILURE() << "seed " << seed << ": " << fault << "\n" << howToRepeat(seed, surface, options);
  }
  return true;
}
} // namespace

// Sharp edges between curved patches, where remeshing once made a surface that cut itself.
TEST(Property, RemeshedRandomBodiesDoNotCutThemselves)
{
  for (const std::uint32_t seed : { 4380U, 4556U, 20324U })
  {
    const bodies::RandomBody random = bodies::randomBody(seed);
    EXPECT_FALSE(random.body.surface.triangles.empty());
    EXPECT_TRUE(ransmesh::findIntersections(random.body.surface).empty()) << "seed " << seed;
  }
}

TEST(Property, RandomBodiesGiveValidMeshes)
{
  runSeeds(30, isMeshed);
}

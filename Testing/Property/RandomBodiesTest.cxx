// Random bodies through the chain: the mesh is always valid. For long runs:
//   RANSMESHING_RANDOM_BODIES=5000 RANSMESHING_FIRST_SEED=1000 RANSMeshingPropertyTests
// A body that fails is written to a file, and what repeats it by ransmesh-cases is printed: seeds give other bodies
// whenever what makes them changes.
#include "Bodies/RandomBodies.h"
#include "Triangles/SurfaceIntersections.h"
#include "Vtk/BodyPolyData.h"
#include "Vtk/ChainRun.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTriangle.h>
#include <vtkXMLPolyDataWriter.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <random>
#include <sstream>

namespace
{
std::uint32_t numberFrom(const char* variable, std::uint32_t usual)
{
  const char* text = std::getenv(variable);
  return text ? static_cast<std::uint32_t>(std::strtoul(text, nullptr, 10)) : usual;
}

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

// The largest of all bodies.
struct VolumeChanges
{
  double byRemoval = 0;
  double byEnrichment = 0;
  double drift = 0; // by removal, see meanDrift
};

double areaOf(vtkPolyData* surface)
{
  double area = 0;
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    area += vtkTriangle::SafeDownCast(surface->GetCell(i))->ComputeArea();
  }
  return area;
}

// How far the surface has come away from where it was, in edges, on the average: what the volume says of it. Of a body
// of 36 points much smaller a drift is a hundredth of the volume than of one of thousands.
double meanDrift(const chain_run::ChainResult& result, vtkPolyData* surface, double edge)
{
  return result.volumeChangeByRemoval * result.volume / (areaOf(surface) * edge);
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

// What is wrong with the mesh of the body, or nothing.
std::string findFault(
  vtkPolyData* surface, double edge, const chain_run::ChainOptions& options, VolumeChanges& largest)
{
  try
  {
    const chain_run::ChainResult result = runChain(surface, options);
    largest.byRemoval = std::max(largest.byRemoval, result.volumeChangeByRemoval);
    largest.byEnrichment = std::max(largest.byEnrichment, result.volumeChange);
    const double drift = meanDrift(result, surface, edge);
    largest.drift = std::max(largest.drift, drift);
    // Round walls lose points, and get new chords, beside concave edges. Where no column may rise, each has its reason:
    // walls too near, or a first height as large as the triangles.
    return !result.faults.empty()                    ? result.faults
      : result.inserted == 0 && result.requested > 0 ? "nothing was inserted"
      : drift >= 5e-3 ? "removal moved the surface by " + std::to_string(drift) + " edges"
      : result.volumeChange >= 5e-4
      ? "enrichment changed the volume by " + std::to_string(result.volumeChange)
      : "";
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
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
  if (const std::string fault = findFault(surface, random.size, options, largest); !fault.empty())
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
  const std::uint32_t count = numberFrom("RANSMESHING_RANDOM_BODIES", 30);
  const std::uint32_t first = numberFrom("RANSMESHING_FIRST_SEED", 1);
  std::uint32_t meshed = 0;
  VolumeChanges largest;
  for (std::uint32_t seed = first; seed < first + count; ++seed)
  {
    meshed += isMeshed(seed, largest) ? 1 : 0;
  }
  std::cout << meshed << " of " << count << " bodies were meshed; their volumes changed by at most "
            << largest.byRemoval << " by removal, " << largest.byEnrichment
            << " by enrichment; removal moved the surface by at most " << largest.drift << " edges\n";
  EXPECT_GE(meshed, count / 2);
}

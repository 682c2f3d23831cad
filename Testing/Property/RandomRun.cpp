#include "RandomRun.h"

#include <vtkPolyData.h>
#include <vtkTriangle.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <sstream>

namespace random_run
{
namespace
{
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
double meanDrift(double change, const chain_run::ChainResult& result, vtkPolyData* surface, double edge)
{
  return change * result.volume / (areaOf(surface) * edge);
}

// The number that the environment variable holds.
std::uint32_t numberFrom(const char* variable, std::uint32_t usual)
{
  const char* text = std::getenv(variable);
  return text ? static_cast<std::uint32_t>(std::strtoul(text, nullptr, 10)) : usual;
}
} // namespace

std::string VolumeChanges::text() const
{
  std::ostringstream out;
  out << "their volumes changed by at most " << byRemoval << " by removal, " << byEnrichment
      << " by enrichment; the surface moved by at most " << driftByRemoval << " and " << driftByEnrichment
      << " edges";
  return out.str();
}

std::string findFault(const std::function<chain_run::ChainResult()>& chain, vtkPolyData* surface, double edge,
  const Drifts& allowed, VolumeChanges& largest)
{
  try
  {
    const chain_run::ChainResult result = chain();
    largest.byRemoval = std::max(largest.byRemoval, result.volumeChangeByRemoval);
    largest.byEnrichment = std::max(largest.byEnrichment, result.volumeChange);
    const double byRemoval = meanDrift(result.volumeChangeByRemoval, result, surface, edge);
    const double byEnrichment = meanDrift(result.volumeChange, result, surface, edge);
    largest.driftByRemoval = std::max(largest.driftByRemoval, byRemoval);
    largest.driftByEnrichment = std::max(largest.driftByEnrichment, byEnrichment);
    // Round walls lose points, and get new chords, beside concave edges. Where no column may rise, each has its reason:
    // walls too near, or a first height as large as the triangles.
    return !result.faults.empty()                    ? result.faults
      : result.inserted == 0 && result.requested > 0 ? "nothing was inserted"
      : byRemoval >= allowed.byRemoval
      ? "removal moved the surface by " + std::to_string(byRemoval) + " edges"
      : byEnrichment >= allowed.byEnrichment
      ? "enrichment moved the surface by " + std::to_string(byEnrichment) + " edges"
      : "";
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
}

void runSeeds(
  std::uint32_t usualCount, const std::function<bool(std::uint32_t seed, VolumeChanges& largest)>& isMeshed)
{
  const std::uint32_t count = numberFrom("RANSMESHING_RANDOM_BODIES", usualCount);
  const std::uint32_t first = numberFrom("RANSMESHING_FIRST_SEED", 1);
  std::uint32_t meshed = 0;
  VolumeChanges largest;
  for (std::uint32_t seed = first; seed < first + count; ++seed)
  {
    meshed += isMeshed(seed, largest) ? 1 : 0;
  }
  std::cout << meshed << " of " << count << " bodies were meshed; " << largest.text() << "\n";
  EXPECT_GE(meshed, count / 2);
}
} // namespace random_run

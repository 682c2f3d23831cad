// What tests of random bodies have in common.
#pragma once

#include "Vtk/ChainRun.h"

#include <cstdint>
#include <functional>
#include <string>

class vtkPolyData;

namespace random_run
{
// The largest of all bodies.
struct VolumeChanges
{
  double byRemoval = 0;
  double byEnrichment = 0;
  // How far the surface came away from where it was, in edges, on the average.
  double driftByRemoval = 0;
  double driftByEnrichment = 0;

  std::string text() const;
};

// How far the surface may move, in edges, on the average.
struct Drifts
{
  double byRemoval;
  double byEnrichment;
};

// What is wrong with the mesh that the chain makes of the surface, whose triangles have this edge, or nothing.
std::string findFault(const std::function<chain_run::ChainResult()>& chain, vtkPolyData* surface, double edge,
  const Drifts& allowed, VolumeChanges& largest);

// Meshes the bodies of as many seeds as is usual, or as the environment asks for; most must be bodies. isMeshed tells
// whether the seed gives a body, and reports its faults itself.
void runSeeds(
  std::uint32_t usualCount, const std::function<bool(std::uint32_t seed, VolumeChanges& largest)>& isMeshed);
} // namespace random_run

// Layers for the tests of regions.
#pragma once

#include "Layers/LayerPlanning.h"

#include <vector>

namespace ransmesh::test
{
// One layer of a given thickness on walls of the grid meshes, however thick it is.
inline LayerPlan planWith(double thickness, const std::vector<int>& walls)
{
  LayerPlan plan(7);
  for (const int wall : walls)
  {
    plan[wall].firstHeight = thickness;
    plan[wall].numberOfLayers = 1;
    plan[wall].isotropicFraction = 100;
  }
  return plan;
}
} // namespace ransmesh::test

// Random bodies of the hard kinds: acute ridges, cones, thin plates, holes through bodies, slots between parts that
// may close, several bodies, cut by planes; sides of all types, unlike layers, any scale, far from the origin.
#pragma once

#include "Bodies/Body.h"
#include "Bodies/Cases.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace bodies
{
struct RandomAssembly
{
  Body body;        // without triangles where the parts make no surface that can be meshed
  double size = 0;  // edge length of its triangles
  double scale = 1; // its extent is about this, 1e-3 to 1e6
  Layers layers;    // 0.03 to 3 edge lengths thick, or of a first height of 1e-7 of the scale
  std::vector<PatchLayers> patchLayers; // of some walls
  std::vector<std::string> walls;       // all walls, where there are patchLayers
  std::optional<double> symmetryPlace;  // the fluid ends in a plane of symmetry across z there
};

// The same seed gives the same assembly.
RandomAssembly randomAssembly(std::uint32_t seed);
} // namespace bodies

// A closed triangulated surface with named patches: what tests and benchmarks put through the chain.
#pragma once

#include "Support/Patch.h"
#include "Triangles/SurfaceMesh.h"

#include <vector>

namespace bodies
{
struct Body
{
  ransmesh::SurfaceMesh surface;
  ransmesh::PatchTable patches;
  bool farField = false;    // a body to be put into a box; else the surface bounds the fluid
  std::vector<Body> sheets; // open surfaces in the fluid: wakes, and walls without thickness
};
} // namespace bodies

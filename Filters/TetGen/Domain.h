// What is to be meshed.
#pragma once

#include "DomainPlane.h"
#include "FarField.h"

#include "Support/Patch.h"
#include "Triangles/SurfaceMesh.h"

#include <optional>
#include <vector>

namespace ransmesh
{
struct Domain
{
  SurfaceMesh surface; // closed, but for its sheets and in the planes
  PatchTable patches;
  std::vector<char> isSheet; // by patch number
  std::optional<FarFieldBox> box;
  std::vector<ClosingPlane> planes; // with a box, some of its sides
  std::vector<int> farField;        // patches that all fluid reaches; none: those of the outermost surface
};
} // namespace ransmesh

// What the stages of the mesher have to say, besides their outcome.
#pragma once

#include "Triangles/SurfaceCheck.h"

#include <functional>
#include <string>
#include <vector>

namespace ransmesh
{
struct MesherReport
{
  std::function<void(const std::string&)> remark; // tells the user a sentence at once
  // The triangles that are wrong, where they are known.
  SurfaceMesh problemSurface;
  std::vector<SurfaceFinding> problems;
};
} // namespace ransmesh

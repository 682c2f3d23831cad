// What a gmsh file holds.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ransmesh
{
struct GmshElement
{
  int type = 0; // gmsh's number of the shape
  int physical = 0;
  int elementary = 0;
  std::array<std::int64_t, 8> points{}; // corners; numbers in `points` below
};

struct GmshContent
{
  std::vector<std::array<double, 3>> points;
  std::vector<GmshElement> elements;
  std::map<std::pair<int, int>, std::string> names; // of (dimension, physical number)
  std::map<int, std::string> types;                 // of patches, which vtkGmshMeshWriter leaves in a comment
};

// How many corners a shape has; 0 for shapes that are not known. Shapes of higher order keep their corners only.
int gmshCorners(int type);

// Reads the formats 2 to 2.2 and 4.1, in text or binary. Throws std::runtime_error for all else.
GmshContent readGmsh(std::string_view file);
} // namespace ransmesh

// A box or a sphere around bodies.
#pragma once

#include "DomainPlane.h"

#include "Support/Patch.h"
#include "Triangles/SurfaceMesh.h"

#include <array>
#include <optional>

namespace ransmesh
{
inline constexpr std::array<const char*, 6> SideNames = { "xmin", "xmax", "ymin", "ymax", "zmin", "zmax" };

struct FarFieldBox
{
  std::array<Vector3, 8> corners;          // corner i: bit 0 high x, bit 1 high y, bit 2 high z
  std::array<std::array<int, 4>, 6> sides; // corners of xmin, xmax, ymin, ymax, zmin, zmax
  std::array<int, 6> patches;              // the patch number of each side
};

// What the user calls a side; no type: what the name suggests.
struct SideName
{
  std::string name;
  std::string type;
};

struct FarFieldOptions
{
  bool isSphere = false;
  // Distances from the bodies' extent to the sides, in body lengths (the largest extent), in the order of the
  // sides; a sphere takes the first.
  std::array<double, 6> margins{};
  std::array<std::optional<SideName>, 6> sides;
};

// BadInput where a side's type is unknown, or where a sphere gets sides.
Outcome checkSides(const FarFieldOptions& options);

// Adds the sides to the table as farfield_xmin, ... of type farfield, or as the options and planes name them; sides
// of one name are one patch. Planes replace the side that they keep the bodies from.
FarFieldBox makeFarField(const Extent& bodies, const FarFieldOptions& options,
  const std::vector<DomainPlane>& planes, PatchTable& patches);

// The number of the side of a box that a plane is.
inline int sideOf(const AxisPlane& plane)
{
  return 2 * plane.axis + (plane.keepsAbove ? 0 : 1);
}

// A sphere around the bodies, cut by the planes, with triangles of edges no longer than `edge` (0: a fifth of
// the radius). Its centre lies amid the bodies, but in the planes. Adds the patch farfield to the table.
SurfaceMesh makeSphere(const Extent& bodies, double margin, double edge,
  const std::vector<DomainPlane>& planes, PatchTable& patches);

// Adds a patch, under another name if there is one of that name already; gives its number.
int addPatch(Patch patch, PatchTable& patches);
} // namespace ransmesh

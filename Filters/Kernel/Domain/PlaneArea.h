// The part of a plane that closes a surface which is open there.
#pragma once

#include "Support/Outcome.h"
#include "Triangles/SurfaceMesh.h"

#include <array>
#include <optional>
#include <vector>

namespace ransmesh
{
struct PlaneEdges
{
  std::vector<std::array<Index, 2>> outline; // around everything; may be empty
  std::vector<std::array<Index, 2>> borders; // between the area and what does not belong to it
  std::vector<std::array<Index, 2>> inside;  // what must be an edge of the area where it lies in it
};

struct PlaneArea
{
  std::vector<std::array<Index, 2>> edges; // those of all three kinds that the area has
  std::vector<Vector3> holes; // a place in each part, bounded by borders, that does not belong to the area
};

// Sorts the plane across `axis` into what belongs to the area and what does not: crossing a border changes it.
// With an outline, the area lies in it, and the outline's part at the point `seed` belongs to it; without one,
// what lies outside all borders does not. The edges are pairs of points, which may meet in points only; all lie in
// the plane. BadInput where edges cross, or do not close around an area.
Outcome findPlaneArea(const std::vector<Vector3>& points, int axis, const PlaneEdges& edges,
  std::optional<Index> seed, PlaneArea& area);
} // namespace ransmesh

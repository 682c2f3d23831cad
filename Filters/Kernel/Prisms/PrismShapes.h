// What the tetrahedra of one prism can become, given which of its quadrilaterals are kept.
#pragma once

#include "Mesh/MixedMesh.h"
#include "Prisms/PrismGroups.h"

#include <optional>

namespace ransmesh
{
// The cells in place of a prism's tetrahedra. A new point, if there is one, has the number NewPoint in them.
struct PrismCells
{
  static constexpr Index NewPoint = -2;

  std::vector<std::array<Index, 4>> tetrahedra;
  std::vector<Pyramid> pyramids;
  std::vector<Wedge> wedges;
  std::vector<Hexahedron> hexahedra;
  bool hasNewPoint = false;
  Vector3 newPoint;
};

class PrismShapes
{
public:
  PrismShapes(const MeshData& mesh, const PrismGroups& groups)
    : mesh_(mesh)
    , groups_(groups)
  {
  }

  // Cells with exactly the kept quadrilaterals, or nothing if there are none that are sound. Without one: the
  // tetrahedra as they are. One: a pyramid upon it where two of the tetrahedra make it. Three that go around the
  // prism: a wedge. Six: a hexahedron. Else, from a new point within, where angles are best: a pyramid upon each,
  // tetrahedra upon all other faces.
  std::optional<PrismCells> make(Index group) const;

  // Is it possible without a new point?
  bool isPyramid(Index group, Index quad) const;

private:
  std::optional<Pyramid> pyramidOf(Index group, Index quad) const;
  std::optional<Wedge> wedgeOf(Index group) const;
  std::optional<Hexahedron> hexahedronOf(Index group) const;
  Index beside(Index point, const std::vector<Index>& quads, const std::array<Index, 4>& base) const;
  std::optional<PrismCells> fromNewPoint(Index group) const;
  std::vector<Index> pointsOf(Index group) const;
  std::vector<Vector3> placesWithin(Index group) const;
  double largestAngleFrom(const Vector3& place, const std::vector<std::array<Index, 3>>& faces) const;
  // The faces of the group that lie in no kept quadrilateral, turned inward.
  std::vector<std::array<Index, 3>> plainFaces(Index group) const;
  bool isInside(Index group, const std::array<Index, 3>& face, Index tet) const;
  // The corners turned into the group.
  std::array<Index, 4> cornersOf(Index group, Index quad) const;
  std::vector<Index> keptQuads(Index group) const;

  const MeshData& mesh_;
  const PrismGroups& groups_;
};
} // namespace ransmesh

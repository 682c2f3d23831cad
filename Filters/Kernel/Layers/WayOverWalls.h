// Whether two places of the walls lie close to each other on the walls, too, or only across the fluid.
#pragma once

#include "Boundary/BoundaryStars.h"
#include "Mesh/LocalNumbers.h"

#include <utility>
#include <vector>

namespace ransmesh
{
class WayOverWalls
{
public:
  WayOverWalls(const TetMesh& mesh, const BoundaryStars& stars)
    : mesh_(mesh)
    , stars_(stars)
  {
  }

  // Ways begin at this vertex of the boundary.
  void beginAt(Index root);
  // Can one come to the face over boundary faces, from edge to edge, without being farther from the root than
  // `within`? Yes, too, where so many faces lie within this distance that it is not found out.
  bool leadsTo(Index face, double within);

private:
  void goOn(Index face, double farthest);
  double distanceTo(Index a, Index b) const;

  const TetMesh& mesh_;
  const BoundaryStars& stars_;
  Vector3 from_;
  LocalNumbers reached_;                       // faces
  std::vector<double> farthest_;               // on the way to each of them
  std::vector<std::pair<double, Index>> open_; // the same of those next to them; a heap, the nearest first
};
} // namespace ransmesh

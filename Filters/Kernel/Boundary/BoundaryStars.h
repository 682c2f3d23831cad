// The boundary faces around each vertex, and what they look like from there.
#pragma once

#include "Mesh/TetMesh.h"

#include <array>
#include <span>
#include <vector>

namespace ransmesh
{
// A boundary face as seen from one of its vertices.
struct FaceAtVertex
{
  std::array<Index, 3> vertex; // turned into the fluid, the vertex itself first
  Vector3 normal;              // unit, into the fluid; zero for a face without area
  double angle;                // at the vertex, radians
  Vector3 middle;              // unit, from the vertex into the face
  int patch;
};

// Built once for a boundary that does not change meanwhile.
class BoundaryStars
{
public:
  explicit BoundaryStars(const TetMesh& mesh);

  // Numbers of the boundary faces at v; empty for a vertex off the boundary.
  std::span<const Index> facesAt(Index v) const
  {
    return { faces_.data() + start_[v], faces_.data() + start_[v + 1] };
  }
  bool isOnBoundary(Index v) const { return start_[v] != start_[v + 1]; }
  FaceAtVertex seenFrom(Index v, Index face) const;

private:
  const TetMesh& mesh_;
  std::vector<std::size_t> start_;
  std::vector<Index> faces_;
};
} // namespace ransmesh

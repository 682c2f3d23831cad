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
  // Of a live boundary face: unit, into the fluid.
  const Vector3& normalOf(Index face) const { return normals_[face]; }
  // Its vertices as TetMesh::boundaryVertices gives them.
  const std::array<Index, 3>& verticesOf(Index face) const { return vertices_[face]; }
  // The same, turned so that v comes first.
  std::array<Index, 3> verticesFrom(Index v, Index face) const
  {
    const auto& w = vertices_[face];
    const int i = w[0] == v ? 0 : w[1] == v ? 1 : 2;
    return { w[i], w[(i + 1) % 3], w[(i + 2) % 3] };
  }
  FaceAtVertex seenFrom(Index v, Index face) const;

private:
  const TetMesh& mesh_;
  std::vector<std::size_t> start_;
  std::vector<Index> faces_;
  // By face. Looked up once: the tetrahedra that have the vertices lie all over the memory.
  std::vector<std::array<Index, 3>> vertices_;
  std::vector<Vector3> normals_;
};
} // namespace ransmesh

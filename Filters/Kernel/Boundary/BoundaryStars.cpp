#include "Boundary/BoundaryStars.h"

#include <cmath>

namespace ransmesh
{
BoundaryStars::BoundaryStars(const TetMesh& mesh)
  : mesh_(mesh)
  , start_(mesh.vertexCount() + 1, 0)
{
  // Looked up once: the tetrahedra that have them lie all over the memory.
  static constexpr std::array<Index, 3> nothing = { None, None, None };
  std::vector<std::array<Index, 3>> vertices(mesh.boundarySlots(), nothing);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const auto b = static_cast<Index>(i);
    vertices[i] = mesh.boundaryFace(b).isAlive() ? mesh.boundaryVertices(b) : nothing;
  }
  const auto forEach = [&vertices](auto visit)
  {
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      if (vertices[i][0] != None)
      {
        for (const Index v : vertices[i])
        {
          visit(v, static_cast<Index>(i));
        }
      }
    }
  };
  forEach([this](Index v, Index) { ++start_[v + 1]; });
  for (std::size_t i = 1; i < start_.size(); ++i)
  {
    start_[i] += start_[i - 1];
  }
  faces_.resize(start_.back());
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  forEach([&](Index v, Index b) { faces_[next[v]++] = b; });
}

FaceAtVertex BoundaryStars::seenFrom(Index v, Index face) const
{
  std::array<Index, 3> vertex = mesh_.boundaryVertices(face);
  while (vertex[0] != v)
  {
    vertex = { vertex[1], vertex[2], vertex[0] };
  }
  const Vector3 e1 = mesh_.point(vertex[1]) - mesh_.point(v);
  const Vector3 e2 = mesh_.point(vertex[2]) - mesh_.point(v);
  const Vector3 n = cross(e1, e2);
  FaceAtVertex seen;
  seen.vertex = vertex;
  seen.normal = normalized(n);
  seen.angle = std::atan2(norm(n), dot(e1, e2));
  seen.middle = normalized(normalized(e1) + normalized(e2));
  seen.patch = mesh_.boundaryFace(face).patch;
  return seen;
}
} // namespace ransmesh

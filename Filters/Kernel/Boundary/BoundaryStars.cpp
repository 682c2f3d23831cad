#include "Boundary/BoundaryStars.h"

#include "Mesh/FaceAhead.h"

#include <cmath>

namespace ransmesh
{
BoundaryStars::BoundaryStars(const TetMesh& mesh)
  : mesh_(mesh)
  , start_(mesh.vertexCount() + 1, 0)
  , vertices_(mesh.boundarySlots(), { None, None, None })
  , normals_(mesh.boundarySlots())
{
  for (std::size_t i = 0; i < vertices_.size(); ++i)
  {
    const auto b = static_cast<Index>(i);
    fetchAheadOfFace(mesh, i);
    if (mesh.boundaryFace(b).isAlive())
    {
      const auto v = mesh.boundaryVertices(b);
      vertices_[i] = v;
      normals_[i] =
        normalized(cross(mesh.point(v[1]) - mesh.point(v[0]), mesh.point(v[2]) - mesh.point(v[0])));
    }
  }
  const auto forEach = [this](auto visit)
  {
    for (std::size_t i = 0; i < vertices_.size(); ++i)
    {
      if (vertices_[i][0] != None)
      {
        for (const Index v : vertices_[i])
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
  FaceAtVertex seen;
  seen.vertex = verticesFrom(v, face);
  const Vector3 e1 = mesh_.point(seen.vertex[1]) - mesh_.point(v);
  const Vector3 e2 = mesh_.point(seen.vertex[2]) - mesh_.point(v);
  seen.normal = normals_[face];
  seen.angle = std::atan2(norm(cross(e1, e2)), dot(e1, e2));
  seen.patch = mesh_.boundaryFace(face).patch;
  return seen;
}
} // namespace ransmesh

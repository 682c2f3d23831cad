// The normals of a surface at its vertices, patch by patch.
#pragma once

#include "Boundary/BoundaryStars.h"

#include <span>
#include <vector>

namespace ransmesh
{
// Groups of a patch's faces around one vertex that hang together through its edges without a turn of
// more than the feature angle between neighbours: one group where the patch is smooth, several where a
// ridge of its own ends or passes.
std::vector<std::vector<FaceAtVertex>> smoothGroups(std::span<const FaceAtVertex> facesOfOnePatch);

// The angle-weighted mean of normals, unit; zero where they cancel.
Vector3 weightedNormal(std::span<const FaceAtVertex> faces);

// Keeps the normals that the surface has when this is built, whatever becomes of it afterwards.
class SurfaceNormals
{
public:
  // Knows no normals.
  SurfaceNormals() = default;
  // wanted: which patches, by number.
  SurfaceNormals(const TetMesh& mesh, const BoundaryStars& stars, const std::vector<char>& wanted);

  // The normal of the patch at v; of several (at a ridge) the one nearest to like; zero where the vertex
  // was not on the patch.
  Vector3 at(Index v, int patch, const Vector3& like) const;

private:
  struct Entry
  {
    Index vertex;
    int patch;
    Vector3 normal;
  };
  std::vector<Entry> entries_; // in order of vertex
};
} // namespace ransmesh

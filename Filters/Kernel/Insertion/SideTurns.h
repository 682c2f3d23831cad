// How far the front turns the surface of the curved sides that it runs along.
#pragma once

#include "Boundary/Classification.h"
#include "Boundary/SurfaceNormals.h"
#include "Layers/Column.h"
#include "Mesh/TetMesh.h"

#include <array>
#include <vector>

namespace ransmesh
{
// Made before the front rises: it remembers the surface as it was.
class SideTurns
{
public:
  // maximumAngle: degrees, by which a triangle may turn away from the surface.
  SideTurns(const TetMesh& mesh, const ColumnSet& set, double maximumAngle);

  // Whether anything has to be watched at all.
  bool anyCurved() const { return anyCurved_; }
  bool isCurved(int patch) const { return isCurved_[patch]; }

  // The cosine between a triangle of a patch, its vertices standing at these places, and the surface
  // that the patch had there: the mean of the normals at the three places.
  double faithfulness(
    int patch, const std::array<Index, 3>& vertex, const std::array<Vector3, 3>& place) const;
  // The same where the vertices are now.
  double faithfulness(Index boundaryFace) const;

  // May a triangle be so, where before there was one of the other faithfulness?
  bool allows(double now, double before) const { return now >= cosine_ || now >= before; }

private:
  Vector3 normalAt(int patch, Index vertex, const Vector3& place, const Vector3& like) const;

  const TetMesh& mesh_;
  const ColumnSet& set_;
  double cosine_;
  std::vector<char> isCurved_; // by patch
  bool anyCurved_;
  SurfaceNormals normals_;
};
} // namespace ransmesh

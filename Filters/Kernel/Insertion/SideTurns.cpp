#include "Insertion/SideTurns.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ransmesh
{
namespace
{
std::vector<char> patchesWithPaths(const ColumnSet& set)
{
  std::vector<char> isCurved(set.heights.size(), 0);
  for (const Column& c : set.columns)
  {
    if (c.levels > 0 && c.path != None)
    {
      isCurved[c.sides[0]] = 1;
      isCurved[c.sides[1]] = 1;
    }
  }
  isCurved[0] = 0;
  return isCurved;
}
} // namespace

SideTurns::SideTurns(const TetMesh& mesh, const ColumnSet& set, double maximumAngle)
  : mesh_(mesh)
  , set_(set)
  , cosine_(std::cos(maximumAngle * std::numbers::pi / 180))
  , isCurved_(patchesWithPaths(set))
  , anyCurved_(std::find(isCurved_.begin(), isCurved_.end(), 1) != isCurved_.end())
  , normals_(anyCurved_ ? SurfaceNormals(mesh, BoundaryStars(mesh), isCurved_) : SurfaceNormals())
{
}

double SideTurns::faithfulness(
  int patch, const std::array<Index, 3>& vertex, const std::array<Vector3, 3>& place) const
{
  const Vector3 normal = normalized(cross(place[1] - place[0], place[2] - place[0]));
  Vector3 mean;
  for (int j = 0; j < 3; ++j)
  {
    mean += normalAt(patch, vertex[j], place[j], normal);
  }
  return dot(normal, normalized(mean));
}

double SideTurns::faithfulness(Index boundaryFace) const
{
  const auto v = mesh_.boundaryVertices(boundaryFace);
  return faithfulness(
    mesh_.boundaryFace(boundaryFace).patch, v, { mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]) });
}

Vector3 SideTurns::normalAt(int patch, Index vertex, const Vector3& place, const Vector3& like) const
{
  const Index column = set_.standingAt(vertex);
  if (column == None || set_.columns[column].path == None || !set_.columns[column].staysIn(patch))
  {
    return normals_.at(vertex, patch, like);
  }
  const Column& c = set_.columns[column];
  const SidePath& path = set_.paths[c.path];
  const auto normal = path.normalsAt(path.heightOf(place));
  const bool second =
    c.sides[1] == patch && (c.sides[0] != patch || dot(normal[1], like) > dot(normal[0], like));
  return normal[second ? 1 : 0];
}
} // namespace ransmesh

#include "Quality/WallPoints.h"

#include "Geometry/Angles.h"
#include "Geometry/Predicates.h"
#include "Mesh/TetMesh.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
MeasuredWallFace makeFace(const MeshData& mesh, HalfFace inner, int patch)
{
  const auto& tet = mesh.tetrahedra[tetOf(inner)];
  const int* corner = FaceCorners[faceOf(inner)];
  MeasuredWallFace face;
  face.patch = patch;
  face.tet = tetOf(inner);
  face.vertex = { tet[corner[0]], tet[corner[1]], tet[corner[2]] };
  const Vector3& a = mesh.points[face.vertex[0]];
  const Vector3 doubleArea = cross(mesh.points[face.vertex[1]] - a, mesh.points[face.vertex[2]] - a);
  const double length = norm(doubleArea);
  face.area = length / 2;
  face.normal = normalized(doubleArea);
  const double sixVolume =
    sixVolumes(mesh.points[tet[0]], mesh.points[tet[1]], mesh.points[tet[2]], mesh.points[tet[3]]);
  face.cellHeight = length > 0 ? sixVolume / length : 0;
  return face;
}

// What the faces at a point add up to.
struct PointSums
{
  Vector3 normal;
  double edges = 0;
  int edgeCount = 0;
  int patch = 0;
  double worstCosine = 1;
};

void addFace(const MeshData& mesh, const MeasuredWallFace& face, std::vector<PointSums>& sums)
{
  for (int i = 0; i < 3; ++i)
  {
    PointSums& at = sums[face.vertex[i]];
    at.normal += face.area * face.normal;
    at.patch = at.patch == 0 ? face.patch : std::min(at.patch, face.patch);
    for (const int other : { (i + 1) % 3, (i + 2) % 3 })
    {
      at.edges += distance(mesh.points[face.vertex[i]], mesh.points[face.vertex[other]]);
      ++at.edgeCount;
    }
  }
}
} // namespace

std::vector<HalfFace> innerFacesOf(const MeshData& mesh, const FaceMatching& matching)
{
  std::vector<HalfFace> innerFaces(mesh.triangles.size(), None);
  for (std::size_t face = 0; face < matching.opposite.size(); ++face)
  {
    const Index other = matching.opposite[face];
    if (other < 0 && other != FaceMatching::Unmatched)
    {
      innerFaces[boundaryFaceOf(other)] = static_cast<HalfFace>(face);
    }
  }
  for (const SheetFace& sheet : matching.sheets)
  {
    innerFaces[sheet.triangle] = sheet.side;
  }
  return innerFaces;
}

std::vector<MeasuredWallFace> wallFacesOf(
  const MeshData& mesh, const std::vector<HalfFace>& innerFaces, const LayerPlan& plan)
{
  std::vector<MeasuredWallFace> faces;
  for (std::size_t i = 0; i < innerFaces.size(); ++i)
  {
    const auto patch = static_cast<std::size_t>(mesh.trianglePatch[i]);
    if (innerFaces[i] != None && patch < plan.size() && plan[patch].hasLayers())
    {
      faces.push_back(makeFace(mesh, innerFaces[i], mesh.trianglePatch[i]));
    }
  }
  return faces;
}

std::vector<ColumnFoot> columnFeetOf(
  const MeshData& mesh, const std::vector<MeasuredWallFace>& faces, double smoothAngle)
{
  std::vector<PointSums> sums(mesh.points.size());
  for (const MeasuredWallFace& face : faces)
  {
    addFace(mesh, face, sums);
  }
  for (PointSums& at : sums)
  {
    at.normal = normalized(at.normal);
  }
  for (const MeasuredWallFace& face : faces)
  {
    for (const Index v : face.vertex)
    {
      sums[v].worstCosine = std::min(sums[v].worstCosine, dot(face.normal, sums[v].normal));
    }
  }
  const double smoothCosine = cosineOfDegrees(smoothAngle);
  std::vector<ColumnFoot> points;
  for (std::size_t v = 0; v < sums.size(); ++v)
  {
    const PointSums& at = sums[v];
    if (at.edgeCount > 0)
    {
      points.push_back({ static_cast<Index>(v), at.patch, at.normal, at.worstCosine > smoothCosine,
        at.edges / at.edgeCount });
    }
  }
  return points;
}
} // namespace ransmesh

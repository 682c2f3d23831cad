#include "TetGenResult.h"

#include "Geometry/Predicates.h"
#include "Mesh/FaceMatching.h"
#include "Mesh/SpatialRenumbering.h"
#include "Mesh/TetMesh.h"
#include "Mesh/Tidying.h"

#include <algorithm>
#include <map>

namespace ransmesh
{
namespace
{
MeshData plainMesh(const worker::Result& result)
{
  MeshData mesh;
  for (std::size_t i = 0; i + 2 < result.points.size(); i += 3)
  {
    mesh.points.push_back({ result.points[i], result.points[i + 1], result.points[i + 2] });
  }
  mesh.tetrahedra.reserve(result.tetrahedra.size() / 4);
  for (std::size_t i = 0; i + 3 < result.tetrahedra.size(); i += 4)
  {
    const std::int32_t* v = result.tetrahedra.data() + i;
    const auto& p = mesh.points;
    const bool turned = orientation(p[v[0]], p[v[1]], p[v[2]], p[v[3]]) < 0;
    mesh.tetrahedra.push_back({ v[0], turned ? v[2] : v[1], turned ? v[1] : v[2], v[3] });
  }
  return mesh;
}

void addFaces(const worker::Result& result, MeshData& mesh)
{
  for (std::size_t i = 0; i + 2 < result.faces.size(); i += 3)
  {
    mesh.triangles.push_back({ result.faces[i], result.faces[i + 1], result.faces[i + 2] });
  }
  mesh.trianglePatch.assign(result.faceMarkers.begin(), result.faceMarkers.end());
}

// The centre of the sphere inside a tetrahedron, and its radius.
std::pair<Vector3, double> inscribedSphere(const MeshData& mesh, const std::array<Index, 4>& tet)
{
  Vector3 centre;
  double area = 0;
  for (int f = 0; f < 4; ++f)
  {
    const Vector3& a = mesh.points[tet[FaceCorners[f][0]]];
    const Vector3& b = mesh.points[tet[FaceCorners[f][1]]];
    const Vector3& c = mesh.points[tet[FaceCorners[f][2]]];
    const double weight = norm(cross(b - a, c - a));
    centre += weight * mesh.points[tet[f]];
    area += weight;
  }
  const auto& p = mesh.points;
  const double volume = std::fabs(sixVolumes(p[tet[0]], p[tet[1]], p[tet[2]], p[tet[3]]));
  return area > 0 ? std::pair{ (1 / area) * centre, volume / area } : std::pair{ centre, 0.0 };
}

} // namespace

std::vector<Vector3> findHoles(const worker::Result& result, const std::vector<int>& farField)
{
  MeshData mesh = plainMesh(result);
  addFaces(result, mesh);
  const FaceMatching matching = matchFaces(mesh);
  const auto reachesFluid = [&](Index opposite)
  {
    const bool isOuter = opposite < 0;
    if (!isOuter || farField.empty())
    {
      return isOuter;
    }
    const int patch =
      opposite == FaceMatching::Unmatched ? None : mesh.trianglePatch[boundaryFaceOf(opposite)];
    return std::find(farField.begin(), farField.end(), patch) != farField.end();
  };
  struct Region
  {
    bool isFluid = false;
    Vector3 inside;
    double room = -1;
  };
  std::map<int, Region> regions;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
  {
    Region& region = regions[result.regions[t]];
    for (int f = 0; f < 4; ++f)
    {
      region.isFluid = region.isFluid || reachesFluid(matching.opposite[4 * t + f]);
    }
    const auto [centre, radius] = inscribedSphere(mesh, mesh.tetrahedra[t]);
    if (radius > region.room)
    {
      region.inside = centre;
      region.room = radius;
    }
  }
  std::vector<Vector3> holes;
  for (const auto& [number, region] : regions)
  {
    if (!region.isFluid)
    {
      holes.push_back(region.inside);
    }
  }
  return holes;
}

AssembledMesh assemble(const worker::Result& result, const std::vector<char>& isSheet)
{
  AssembledMesh assembled;
  MeshData& mesh = assembled.mesh;
  mesh = plainMesh(result);
  addFaces(result, mesh);
  const FaceMatching matching = matchFaces(mesh);
  std::vector<char> onBoundary(mesh.triangles.size(), 0);
  for (std::size_t face = 0; face < matching.opposite.size(); ++face)
  {
    const Index other = matching.opposite[face];
    if (other < 0 && other != FaceMatching::Unmatched)
    {
      const Index triangle = boundaryFaceOf(other);
      const auto& tet = mesh.tetrahedra[face / 4];
      const int* corner = FaceCorners[face % 4];
      mesh.triangles[triangle] = { tet[corner[0]], tet[corner[2]], tet[corner[1]] };
      onBoundary[triangle] = 1;
    }
  }
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto patch = static_cast<std::size_t>(mesh.trianglePatch[t]);
    if (onBoundary[t] || (patch < isSheet.size() && isSheet[patch]))
    {
      mesh.triangles[kept] = mesh.triangles[t];
      mesh.trianglePatch[kept++] = mesh.trianglePatch[t];
    }
    else
    {
      assembled.unexpected.triangles.push_back(mesh.triangles[t]);
      assembled.unexpected.trianglePatch.push_back(mesh.trianglePatch[t]);
    }
  }
  mesh.triangles.resize(kept);
  mesh.trianglePatch.resize(kept);
  if (!assembled.unexpected.triangles.empty())
  {
    assembled.unexpected.points = mesh.points;
  }
  dropUnusedPoints(mesh);
  renumberSpatially(mesh);
  sortByPatch(mesh);
  return assembled;
}
} // namespace ransmesh

#include "Mesh/Validation.h"

#include "Geometry/CoincidentPoints.h"
#include "Geometry/Predicates.h"
#include "Support/FaultList.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
template <class Cells>
std::size_t countOutOfRange(const Cells& cells, std::size_t points, Index& first)
{
  std::size_t bad = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const bool wrong = std::any_of(cells[i].begin(), cells[i].end(),
      [points](Index v) { return v < 0 || static_cast<std::size_t>(v) >= points; });
    if (wrong && bad++ == 0)
    {
      first = static_cast<Index>(i);
    }
  }
  return bad;
}

void checkPoints(const MeshData& mesh, MeshFaults& faults)
{
  const auto& p = mesh.points;
  std::vector<char> used(p.size(), 0);
  for (const auto& tet : mesh.tetrahedra)
  {
    for (const Index v : tet)
    {
      used[v] = 1;
    }
  }
  const auto note = [&](std::size_t& counter, std::size_t v)
  {
    ++counter;
    faults.firstPoint = faults.firstPoint == None ? static_cast<Index>(v) : faults.firstPoint;
  };
  for (std::size_t v = 0; v < p.size(); ++v)
  {
    if (!isFinite(p[v]))
    {
      note(faults.pointsNotFinite, v);
    }
    if (!used[v])
    {
      note(faults.pointsUnused, v);
    }
  }
  if (faults.pointsNotFinite || mesh.isOpened)
  {
    return;
  }
  for (const Index v : findCoincident(p))
  {
    note(faults.pointsCoincident, v);
  }
}

void checkTets(const MeshData& mesh, MeshFaults& faults)
{
  const auto& p = mesh.points;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
  {
    const auto& v = mesh.tetrahedra[t];
    if (!isPositive(p[v[0]], p[v[1]], p[v[2]], p[v[3]]) && faults.tetsNotPositive++ == 0)
    {
      faults.firstTet = static_cast<Index>(t);
    }
  }
}

// A triangle is outward when it is an odd permutation of its tetrahedron's inward face.
bool isTurnedInward(const std::array<Index, 3>& triangle, const std::array<Index, 4>& tet, int f)
{
  for (int i = 0; i < 3; ++i)
  {
    if (triangle[i] == tet[FaceCorners[f][0]])
    {
      return triangle[(i + 1) % 3] == tet[FaceCorners[f][1]];
    }
  }
  return true;
}

void checkFaces(const MeshData& mesh, MeshFaults& faults, FaceMatching& matching)
{
  matching = matchFaces(mesh);
  faults.facesInMoreThanTwoTets = matching.facesInMoreThanTwoTets;
  faults.facesWithoutTriangle = matching.facesWithoutTriangle;
  faults.trianglesOffTheBoundary = matching.trianglesOffTheBoundary;
  faults.repeatedTriangles = matching.repeatedTriangles;
  faults.firstTet = faults.firstTet == None ? matching.firstFaultyTet : faults.firstTet;
  faults.firstTriangle = matching.firstFaultyTriangle;
  for (std::size_t face = 0; face < matching.opposite.size(); ++face)
  {
    const Index other = matching.opposite[face];
    if (other >= 0 || other == FaceMatching::Unmatched)
    {
      continue;
    }
    const Index triangle = boundaryFaceOf(other);
    const auto h = static_cast<HalfFace>(face);
    if (isTurnedInward(mesh.triangles[triangle], mesh.tetrahedra[tetOf(h)], faceOf(h)) &&
      faults.trianglesTurnedInward++ == 0)
    {
      faults.firstTriangle = triangle;
    }
  }
}
} // namespace

bool MeshFaults::none() const
{
  return !indicesOutOfRange && !pointsNotFinite && !pointsCoincident && !pointsUnused && !tetsNotPositive &&
    !facesInMoreThanTwoTets && !facesWithoutTriangle && !trianglesOffTheBoundary && !repeatedTriangles &&
    !trianglesTurnedInward && !brokenLinks;
}

std::string MeshFaults::text() const
{
  FaultList list;
  list.add(indicesOutOfRange, "cells with point numbers out of range");
  list.add(pointsNotFinite, "points not finite");
  list.add(pointsCoincident, "coincident points");
  list.add(pointsUnused, "unused points");
  list.add(tetsNotPositive, "tetrahedra not positive");
  list.add(facesInMoreThanTwoTets, "faces in more than two tetrahedra");
  list.add(facesWithoutTriangle, "boundary faces without a triangle");
  list.add(trianglesOffTheBoundary, "triangles off the boundary");
  list.add(repeatedTriangles, "repeated triangles");
  list.add(trianglesTurnedInward, "boundary triangles turned inward");
  list.add(brokenLinks, "broken links between tetrahedra");
  std::string out = list.text();
  const auto place = [&out](Index i, const char* what)
  {
    if (i != None)
    {
      out += std::string("; first ") + what + " " + std::to_string(i);
    }
  };
  place(firstTet, "tetrahedron");
  place(firstTriangle, "triangle");
  place(firstPoint, "point");
  return out;
}

MeshFaults findFaults(const MeshData& mesh, FaceMatching* matching)
{
  MeshFaults faults;
  faults.indicesOutOfRange = countOutOfRange(mesh.tetrahedra, mesh.points.size(), faults.firstTet) +
    countOutOfRange(mesh.triangles, mesh.points.size(), faults.firstTriangle);
  if (faults.indicesOutOfRange)
  {
    return faults;
  }
  checkPoints(mesh, faults);
  if (faults.pointsNotFinite)
  {
    return faults;
  }
  checkTets(mesh, faults);
  FaceMatching own;
  checkFaces(mesh, faults, matching ? *matching : own);
  return faults;
}

MeshFaults findFaults(const TetMesh& mesh)
{
  MeshFaults faults = findFaults(toMeshData(mesh));
  faults.pointsUnused = 0; // vertices under change may be unused for a while
  const auto sideOf = [&mesh](HalfFace h)
  {
    return isBoundary(h) ? mesh.boundaryFace(boundaryFaceOf(h)).inner
                         : mesh.tet(tetOf(h)).neighbour[faceOf(h)];
  };
  for (std::size_t t = 0; t < mesh.tetSlots(); ++t)
  {
    const auto tet = static_cast<Index>(t);
    if (!mesh.tet(tet).isAlive())
    {
      continue;
    }
    for (int f = 0; f < 4; ++f)
    {
      const HalfFace other = mesh.tet(tet).neighbour[f];
      const bool alive = isBoundary(other) || mesh.tet(tetOf(other)).isAlive();
      faults.brokenLinks += !alive || sideOf(other) != halfFace(tet, f);
    }
    for (const Index v : mesh.tet(tet).vertex)
    {
      const Index at = mesh.tetAt(v);
      faults.brokenLinks += at == None || !mesh.tet(at).isAlive() || !mesh.tet(at).has(v);
    }
  }
  return faults;
}

double totalVolume(const MeshData& mesh)
{
  double volume = 0;
  for (const auto& v : mesh.tetrahedra)
  {
    volume += sixVolumes(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]) / 6;
  }
  return volume;
}
} // namespace ransmesh

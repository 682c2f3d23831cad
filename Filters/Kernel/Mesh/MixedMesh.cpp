#include "Mesh/MixedMesh.h"

#include "Geometry/Predicates.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
void add(const std::array<Index, 4>& tet, Index cell, SplitMesh& result)
{
  result.mesh.tetrahedra.push_back(tet);
  result.cell.push_back(cell);
}

// The base is cut from its lowest number.
void cut(const Pyramid& v, Index cell, SplitMesh& result)
{
  const auto lowest = std::min_element(v.begin(), v.begin() + 4) - v.begin();
  const auto at = [&](std::ptrdiff_t i) { return v[(lowest + i) % 4]; };
  add({ at(0), at(1), at(2), v[4] }, cell, result);
  add({ at(0), at(2), at(3), v[4] }, cell, result);
}

// From the wedge's lowest point: a tetrahedron upon the triangle that is not its own, and a pyramid, cut in its
// turn, upon the quadrilateral that does not hold it.
void cut(const Wedge& v, Index cell, SplitMesh& result)
{
  const auto lowest = std::min_element(v.begin(), v.end()) - v.begin();
  const bool isTop = lowest >= 3;
  const auto column = lowest % 3;
  const auto own = [&](std::ptrdiff_t i) { return v[(isTop ? 3 : 0) + (column + i) % 3]; };
  const auto other = [&](std::ptrdiff_t i) { return v[(isTop ? 0 : 3) + (column + i) % 3]; };
  if (isTop)
  {
    add({ other(0), other(2), other(1), own(0) }, cell, result);
    cut(Pyramid{ own(2), own(1), other(1), other(2), own(0) }, cell, result);
    return;
  }
  add({ other(0), other(1), other(2), own(0) }, cell, result);
  cut(Pyramid{ own(1), own(2), other(2), other(1), own(0) }, cell, result);
}

// Pyramids upon the three faces that do not hold the lowest point.
void cut(const Hexahedron& v, Index cell, SplitMesh& result)
{
  const Index lowest = *std::min_element(v.begin(), v.end());
  for (const Polygon& face : facesOf(v))
  {
    if (std::find(face.begin(), face.end(), lowest) == face.end())
    {
      cut(Pyramid{ face[3], face[2], face[1], face[0], lowest }, cell, result);
    }
  }
}
} // namespace

bool isSound(const Pyramid& v, const std::vector<Vector3>& p)
{
  for (int i = 0; i < 4; ++i)
  {
    if (!isPositive(p[v[i]], p[v[(i + 1) % 4]], p[v[(i + 3) % 4]], p[v[4]]))
    {
      return false;
    }
  }
  return true;
}

// Every cut raises the three corners one after the other: the first or last to rise gives a corner's
// tetrahedron, the second one a tetrahedron amid.
bool isSound(const Wedge& v, const std::vector<Vector3>& p)
{
  const std::array<Index, 3> low{ v[0], v[2], v[1] };
  const std::array<Index, 3> high{ v[3], v[5], v[4] };
  for (int first = 0; first < 3; ++first)
  {
    if (!isPositive(p[low[0]], p[low[1]], p[low[2]], p[high[first]]) ||
      !isPositive(p[high[0]], p[high[2]], p[high[1]], p[low[first]]))
    {
      return false;
    }
    std::array<Index, 3> raised = low;
    raised[first] = high[first];
    for (const int second : { (first + 1) % 3, (first + 2) % 3 })
    {
      if (!isPositive(p[raised[0]], p[raised[1]], p[raised[2]], p[high[second]]))
      {
        return false;
      }
    }
  }
  return true;
}

bool isSound(const Hexahedron& v, const std::vector<Vector3>& p)
{
  const auto faces = facesOf(v);
  return std::all_of(v.begin(), v.end(),
    [&](Index tip)
    {
      return std::all_of(faces.begin(), faces.end(),
        [&](const Polygon& face)
        {
          return std::find(face.begin(), face.end(), tip) != face.end() ||
            isSound(Pyramid{ face[3], face[2], face[1], face[0], tip }, p);
        });
    });
}

SplitMesh splitIntoTets(const MixedMesh& mixed)
{
  SplitMesh result;
  result.mesh.points = mixed.points;
  Index cell = 0;
  for (const auto& tet : mixed.tetrahedra)
  {
    add(tet, cell++, result);
  }
  for (const Pyramid& pyramid : mixed.pyramids)
  {
    cut(pyramid, cell++, result);
  }
  for (const Wedge& wedge : mixed.wedges)
  {
    cut(wedge, cell++, result);
  }
  for (const Hexahedron& hexahedron : mixed.hexahedra)
  {
    cut(hexahedron, cell++, result);
  }
  const auto addTriangle = [&](Index a, Index b, Index c, std::size_t polygon)
  {
    result.mesh.triangles.push_back({ a, b, c });
    result.mesh.trianglePatch.push_back(mixed.boundaryPatch[polygon]);
    result.polygon.push_back(static_cast<Index>(polygon));
  };
  for (std::size_t i = 0; i < mixed.boundary.size(); ++i)
  {
    const Polygon& v = mixed.boundary[i];
    if (isTriangle(v))
    {
      addTriangle(v[0], v[1], v[2], i);
      continue;
    }
    const auto lowest = std::min_element(v.begin(), v.end()) - v.begin();
    addTriangle(v[lowest], v[(lowest + 1) % 4], v[(lowest + 2) % 4], i);
    addTriangle(v[lowest], v[(lowest + 2) % 4], v[(lowest + 3) % 4], i);
  }
  return result;
}
} // namespace ransmesh

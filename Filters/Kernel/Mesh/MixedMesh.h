// A mesh of tetrahedra, pyramids, wedges and hexahedra with a boundary of triangles and quadrilaterals: what
// solvers get.
#pragma once

#include "Mesh/MeshData.h"

#include <array>
#include <vector>

namespace ransmesh
{
// Points of each cell in VTK's order.
using Pyramid = std::array<Index, 5>;    // the base 0 1 2 3 turns towards 4
using Wedge = std::array<Index, 6>;      // the triangle 0 1 2 turns away from 3 4 5; edges 0-3, 1-4, 2-5
using Hexahedron = std::array<Index, 8>; // the base 0 1 2 3 turns towards 4 5 6 7; edges 0-4, 1-5, 2-6, 3-7
// A triangle (then the last is None) or a quadrilateral.
using Polygon = std::array<Index, 4>;

struct MixedMesh
{
  std::vector<Vector3> points;
  std::vector<std::array<Index, 4>> tetrahedra; // cells are numbered in this order
  std::vector<Pyramid> pyramids;
  std::vector<Wedge> wedges;
  std::vector<Hexahedron> hexahedra;
  std::vector<Polygon> boundary; // turned outward, sorted by patch; sheets turned either way
  std::vector<int> boundaryPatch;

  std::size_t cellCount() const
  {
    return tetrahedra.size() + pyramids.size() + wedges.size() + hexahedra.size();
  }
};

inline bool isTriangle(const Polygon& polygon)
{
  return polygon[3] == None;
}

// The faces of a cell, turned outward.
inline std::array<Polygon, 4> facesOf(const std::array<Index, 4>& v)
{
  return { { { v[1], v[2], v[3], None }, { v[0], v[3], v[2], None }, { v[0], v[1], v[3], None },
    { v[0], v[2], v[1], None } } };
}
inline std::array<Polygon, 5> facesOf(const Pyramid& v)
{
  return { { { v[0], v[3], v[2], v[1] }, { v[0], v[1], v[4], None }, { v[1], v[2], v[4], None },
    { v[2], v[3], v[4], None }, { v[3], v[0], v[4], None } } };
}
inline std::array<Polygon, 5> facesOf(const Wedge& v)
{
  return { { { v[0], v[1], v[2], None }, { v[3], v[5], v[4], None }, { v[0], v[3], v[4], v[1] },
    { v[1], v[4], v[5], v[2] }, { v[2], v[5], v[3], v[0] } } };
}
inline std::array<Polygon, 6> facesOf(const Hexahedron& v)
{
  return { { { v[0], v[3], v[2], v[1] }, { v[4], v[5], v[6], v[7] }, { v[0], v[1], v[5], v[4] },
    { v[1], v[2], v[6], v[5] }, { v[2], v[3], v[7], v[6] }, { v[3], v[0], v[4], v[7] } } };
}

// Exact: all corners are positive, and so is every tetrahedron of every way to cut the cell into tetrahedra
// without a new point.
bool isSound(const Pyramid& v, const std::vector<Vector3>& p);
bool isSound(const Wedge& v, const std::vector<Vector3>& p);
bool isSound(const Hexahedron& v, const std::vector<Vector3>& p); // of every way from one of its corners

// The same mesh in tetrahedra and triangles. Each quadrilateral is cut from its lowest point number, so that
// both sides agree; sound cells give positive tetrahedra.
struct SplitMesh
{
  MeshData mesh;
  std::vector<Index> cell;    // of each tetrahedron: the mixed mesh's
  std::vector<Index> polygon; // of each triangle: the boundary polygon
};
SplitMesh splitIntoTets(const MixedMesh& mixed);
} // namespace ransmesh

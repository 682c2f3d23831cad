// Small polyhedra whose corners are joined to one point inside.
#pragma once

#include "Mesh/MeshData.h"

#include <array>
#include <cmath>
#include <vector>

namespace wall_star
{
struct Polyhedron
{
  std::vector<ransmesh::Vector3> points;
  std::vector<std::array<ransmesh::Index, 3>> faces; // turned inward
};

// A prism over a triangle whose top is turned, degrees, so that its sides bend in along their diagonals: Schoenhardt's
// polyhedron, which no tetrahedra between its corners fill.
inline Polyhedron schoenhardt(double turn = 30)
{
  Polyhedron body;
  const double third = 2 * std::acos(-1.0) / 3;
  for (const double z : { 0.0, 1.0 })
  {
    for (int i = 0; i < 3; ++i)
    {
      const double angle = i * third + z * turn * third / 120;
      body.points.push_back({ std::cos(angle), std::sin(angle), z });
    }
  }
  body.faces = { { 0, 1, 2 }, { 3, 5, 4 } };
  for (int i = 0; i < 3; ++i)
  {
    const int next = (i + 1) % 3;
    body.faces.push_back({ i, 3 + next, next }); // the diagonal from i to 3 + next
    body.faces.push_back({ i, 3 + i, 3 + next });
  }
  return body;
}

// A cube, cut along x = y into two prisms that tetrahedra fill, whose other diagonals are such that no corner sees all
// faces.
inline Polyhedron cube()
{
  Polyhedron body;
  for (int i = 0; i < 8; ++i)
  {
    body.points.push_back({ double(i & 1), double(i >> 1 & 1), double(i >> 2) });
  }
  body.faces = { { 0, 1, 3 }, { 0, 3, 2 }, { 4, 7, 5 }, { 4, 6, 7 }, // z = 0, z = 1
    { 0, 5, 1 }, { 0, 4, 5 }, { 1, 5, 3 }, { 3, 5, 7 },              // y = 0, x = 1
    { 0, 2, 4 }, { 2, 6, 4 }, { 2, 3, 7 }, { 2, 7, 6 } };            // x = 0, y = 1
  return body;
}

// The mesh of a polyhedron's corners and a point, all faces of patch 1.
inline ransmesh::MeshData meshOf(const Polyhedron& body, const ransmesh::Vector3& inside)
{
  ransmesh::MeshData mesh;
  mesh.points = body.points;
  mesh.points.push_back(inside);
  const auto centre = static_cast<ransmesh::Index>(body.points.size());
  for (const auto& f : body.faces)
  {
    mesh.tetrahedra.push_back({ f[0], f[1], f[2], centre });
    mesh.triangles.push_back({ f[0], f[2], f[1] });
    mesh.trianglePatch.push_back(1);
  }
  return mesh;
}
} // namespace wall_star

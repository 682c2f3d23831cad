// Structured grids of tetrahedra on the unit cube, mapped as one likes: domains whose answers are known.
#pragma once

#include "Mesh/MeshData.h"
#include "Support/Patch.h"

#include <array>
#include <functional>
#include <random>

namespace grid_mesh
{
using ransmesh::Index;
using ransmesh::MeshData;
using ransmesh::Vector3;

// The patches of the cube's sides.
enum Side
{
  XLow = 1,
  XHigh,
  YLow,
  YHigh,
  ZLow,
  ZHigh
};

struct Grid
{
  int nx = 6;
  int ny = 6;
  int nz = 6;
  std::function<Vector3(const Vector3&)> map = {}; // of the unit cube; none: the cube itself
  double jitter = 0;                               // of inner points, in cells
  unsigned seed = 1;
};

// The patch of a side's triangle by its middle in the unit cube; may split sides.
using PatchOf = std::function<int(Side, const Vector3&)>;

// Six tetrahedra a cell, all cells alike (Kuhn): valid for every map that keeps them positive.
MeshData make(const Grid& grid, const PatchOf& patchOf = {});

// All sides of one type, under the names x_low to z_high.
ransmesh::PatchTable patches(ransmesh::PatchType type, int count = 6);

// Makes those faces between two tetrahedra a sheet, of the next free patch number, whose middles the choice
// takes. Gives the number.
int addSheet(MeshData& mesh, const std::function<bool(const Vector3& middle)>& choice);

// Takes out the tetrahedra whose middles the choice takes; the faces that this uncovers become a patch of
// the next free number, which is given back. What is left must still be a domain.
int carve(MeshData& mesh, const std::function<bool(const Vector3& middle)>& choice);

Vector3 turned(const Vector3& p); // to no axis
} // namespace grid_mesh

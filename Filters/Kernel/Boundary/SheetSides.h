// Sheets of a mesh, and what is on which side of them at each of their points.
//
// A sheet is a patch whose triangles all lie inside the mesh, between two tetrahedra: a wake, or a wall
// without thickness.
#pragma once

#include "Mesh/TetMesh.h"

#include <array>
#include <span>
#include <vector>

namespace ransmesh
{
struct SheetTriangle
{
  Index triangle = None;
  // The faces of the two tetrahedra; the triangle is turned outward for the first.
  std::array<HalfFace, 2> face{ None, None };
};

// All triangles of sheets, in order of number; none if point numbers are out of range. Patches that lie on
// the boundary, too, are no sheets: the mesh is not valid then. Costs a look at each tetrahedron.
std::vector<SheetTriangle> findSheets(const MeshData& mesh);

// The tetrahedra at each point of the sheets, in parts that the sheets keep apart: two tetrahedra belong to
// one part if one gets from one to the other through faces at the point, and through no sheet. One part is at
// the free border, two are inside a sheet, more where sheets join.
class SheetSides
{
public:
  SheetSides(const MeshData& mesh, const std::vector<SheetTriangle>& sheets);

  // The points of the sheets, ascending.
  const std::vector<Index>& points() const { return points_; }
  bool isOnSheet(Index v) const { return row_[v] != None; }
  // The tetrahedra at a point of a sheet, ascending.
  std::span<const Index> tetsAt(Index v) const
  {
    return { tets_.data() + start_[row_[v]], tets_.data() + start_[row_[v] + 1] };
  }
  // How many parts the tetrahedra at a point of a sheet make up.
  int partsAt(Index v) const { return parts_[row_[v]]; }
  // To which part one of them belongs, from 0.
  int partOf(Index v, Index tet) const;

private:
  void collectTets(const MeshData& mesh);
  void partTets(const MeshData& mesh, Index v, const std::vector<HalfFace>& sheetFaces);

  std::vector<Index> points_;
  std::vector<Index> row_;         // by point: its row, or None
  std::vector<std::size_t> start_; // of each row
  std::vector<Index> tets_;
  std::vector<int> part_; // of each entry of tets_
  std::vector<int> parts_;
};
} // namespace ransmesh

// A mesh for a solver's file, read in place from a vtkUnstructuredGrid: cells by kind, boundary faces by
// patch. Nothing of the grid is copied but the numbers of its boundary faces.
#ifndef MeshView_h
#define MeshView_h

#include "Support/Outcome.h"
#include "Support/Patch.h"

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkPoints;
class vtkUnstructuredGrid;

namespace ransmesh
{
enum class CellKind
{
  Tetrahedron,
  Pyramid,
  Wedge,
  Hexahedron,
  Triangle,
  Quadrilateral
};
inline constexpr std::array<CellKind, 4> VolumeKinds = { CellKind::Tetrahedron, CellKind::Pyramid,
  CellKind::Wedge, CellKind::Hexahedron };

// The points of a cell or face. Volume cells are turned so that the first face's normal points into the
// cell (tetrahedron 0 1 2, pyramid 0 1 2 3, wedge 0 1 2, hexahedron 0 1 2 3), as CGNS, gmsh, UGRID, SU2 have
// it; VTK's own wedges are the other way round.
struct Corners
{
  CellKind kind = CellKind::Tetrahedron;
  int count = 0;
  std::array<vtkIdType, 8> points;

  const vtkIdType* begin() const { return points.data(); }
  const vtkIdType* end() const { return points.data() + count; }
  vtkIdType operator[](int i) const { return points[i]; }
};

// A part of the volume with a number of its own.
struct Region
{
  int id = 1;
  std::string name;
  std::array<vtkIdType, 4> cells{}; // of each of VolumeKinds

  vtkIdType count() const { return cells[0] + cells[1] + cells[2] + cells[3]; }
};

// A patch that has faces. Its faces are the view's faces first to first + count - 1.
struct BoundaryPatch
{
  int id = 0;
  std::string name;
  PatchType type = PatchType::Patch;
  bool inside = false;  // a sheet: cells on both sides
  bool divides = false; // of a sheet: these cells are of two regions
  vtkIdType first = 0;
  vtkIdType triangles = 0;
  vtkIdType quadrilaterals = 0;

  vtkIdType count() const { return triangles + quadrilaterals; }
};

// Valid as long as the grid that it was made of, unchanged.
class MeshView
{
public:
  // BadInput for a grid without volume cells or without PatchId on its faces, with cells of other kinds than
  // those of CellKind, or with point numbers out of range.
  static Outcome make(vtkUnstructuredGrid* grid, MeshView& view);

  vtkIdType numberOfPoints() const { return pointCount_; }
  std::array<double, 3> point(vtkIdType i) const;

  vtkIdType numberOfCells() const { return cellCount_; } // volume cells
  // Of faces, too, if that is the kind.
  vtkIdType numberOfCells(CellKind kind) const { return kindCounts_[static_cast<int>(kind)]; }
  Corners cell(vtkIdType i) const { return turned(unturnedCell(i)); }
  // As it stands in the grid: where only its points matter.
  Corners unturnedCell(vtkIdType i) const { return corners(gridCell(i)); }
  // Calls act(Corners, region) for each volume cell of a kind, in the grid's order.
  template <class Act>
  void forEachCell(CellKind kind, Act act) const
  {
    for (vtkIdType i = 0; numberOfCells(kind) > 0 && i < cellCount_; ++i)
    {
      if (kindOfCell(i) == kind)
      {
        act(cell(i), regionOf(i));
      }
    }
  }
  CellKind kindOfCell(vtkIdType i) const { return kinds_[types_[gridCell(i)]]; }

  // By number; one if the grid tells of none.
  const std::vector<Region>& regions() const { return regions_; }
  // The region of a volume cell, by its place in regions().
  std::size_t regionOf(vtkIdType i) const { return cellRegions_.empty() ? 0 : cellRegions_[i]; }

  // Forgets the patches inside the mesh, or those alone that do not divide regions.
  void leaveOutSheets(bool dividingOnesToo);
  // By patch number; sheets among them.
  const std::vector<BoundaryPatch>& patches() const { return patches_; }
  vtkIdType numberOfFaces() const { return static_cast<vtkIdType>(faceIds_.size()); }
  Corners face(vtkIdType i) const { return corners(faceIds_[i]); }
  // The grid's numbers of a volume cell and of a boundary face.
  vtkIdType gridCell(vtkIdType i) const { return cellIds_.empty() ? i : cellIds_[i]; }
  vtkIdType gridFace(vtkIdType i) const { return faceIds_[i]; }

private:
  Corners corners(vtkIdType id) const;
  Corners turned(Corners cell) const;
  Outcome readArrays(vtkUnstructuredGrid* grid);
  Outcome countCells();
  Outcome checkCell(vtkIdType id) const;
  Outcome readPatches(vtkUnstructuredGrid* grid);
  Outcome readRegions(vtkUnstructuredGrid* grid);
  void findSheets();

  vtkPoints* points_ = nullptr;
  const double* doubles_ = nullptr; // the points, where they are stored so
  const unsigned char* types_ = nullptr;
  const vtkTypeInt64* offsets64_ = nullptr; // of the two storages of vtkCellArray, the one in use
  const vtkTypeInt64* connectivity64_ = nullptr;
  const vtkTypeInt32* offsets32_ = nullptr;
  const vtkTypeInt32* connectivity32_ = nullptr;
  vtkIdType pointCount_ = 0;
  vtkIdType gridCells_ = 0;
  vtkIdType cellCount_ = 0;
  std::array<vtkIdType, 6> kindCounts_{};
  std::vector<vtkIdType> cellIds_; // empty where the volume cells come first
  std::vector<vtkIdType> faceIds_; // sorted by patch
  std::vector<BoundaryPatch> patches_;
  std::string fluidName_;
  std::vector<Region> regions_;
  std::vector<std::uint16_t> cellRegions_; // empty where there is one

  static const std::array<CellKind, 256> kinds_;
};
} // namespace ransmesh

#endif

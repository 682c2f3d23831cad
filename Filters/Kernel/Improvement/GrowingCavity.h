// A set of tetrahedra to be starred again from a vertex yet to be chosen, and how good that would be.
#pragma once

#include "Boundary/Classification.h"
#include "Geometry/TetrahedronMeasures.h"
#include "Mesh/Marks.h"
#include "Mesh/Star.h"
#include "Mesh/TetMesh.h"

#include <array>
#include <initializer_list>
#include <span>
#include <vector>

namespace ransmesh
{
// The quality (Geometry/TetrahedronMeasures.h) of a live tetrahedron of the mesh.
double qualityOf(const TetMesh& mesh, Index t);

// Which boundary faces may be starred again, and what stands on the boundary.
struct BoundaryRules
{
  Classification classification;
  std::vector<char> changeable; // by patch number

  // May a face of this patch be starred from the apex? Only if the apex lies on the patch.
  bool mayStar(int patch, Index apex) const;
};

class GrowingCavity
{
public:
  GrowingCavity(const TetMesh& mesh, const BoundaryRules& rules, ShapeMeasure measure = quality)
    : mesh_(mesh)
    , rules_(rules)
    , measure_(measure)
  {
  }

  // Begins with these tetrahedra; of their boundary faces, those that have all vertices in vanishing
  // (none, a vertex, or an edge) are to be starred again.
  void begin(std::span<const Index> tets, std::initializer_list<Index> vanishing);

  // The worst quality of the tetrahedra that would come, the cavity being as it began; gives up, with
  // floor or less, as soon as one is not better than floor.
  double worstFrom(Index apex, double floor);

  // How many outer faces see the apex no better than floor, the cavity being as it began.
  std::size_t countPoor(Index apex, double floor);

  // Grows the cavity beyond every face that sees the apex no better than floor, by at most budget
  // tetrahedra; boundary faces that see it so are starred where the rules allow it. Gives the worst
  // quality then, or floor where that does not help. Undone by the next worstFrom, grow or begin.
  double grow(Index apex, double floor, std::size_t budget);

  // What was begun with, or grown last.
  const Cavity& cavity() const { return cavity_; }

private:
  struct OuterFace
  {
    std::array<Index, 3> vertex; // turned inward
    HalfFace beyond;
    bool starred;
    double quality; // seen from the apex, where it was needed

    bool has(Index v) const { return vertex[0] == v || vertex[1] == v || vertex[2] == v; }
  };

  void addOuterFaces(Index tet, std::span<const Index> vanishing);
  void undoGrowth();
  double qualityFrom(const OuterFace& face, const Vector3& apex) const;
  bool passFace(std::size_t i, Index apex, double floor, std::size_t limit);
  double worstOfOuterFaces(Index apex) const;

  const TetMesh& mesh_;
  const BoundaryRules& rules_;
  ShapeMeasure measure_;
  Cavity cavity_;
  Marks inCavity_;
  std::vector<OuterFace> faces_;
  std::size_t tetsAtBegin_ = 0;
  std::size_t facesAtBegin_ = 0;
  std::size_t starredAtBegin_ = 0;
};
} // namespace ransmesh

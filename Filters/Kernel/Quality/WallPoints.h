// The points and faces of the viscous walls, as the report sees them.
#pragma once

#include "Layers/LayerSpecification.h"
#include "Mesh/FaceMatching.h"
#include "Mesh/TetMesh.h"
#include "Support/Patch.h"

#include <vector>

namespace ransmesh
{
struct MeasuredWallFace
{
  int patch = 0;
  Index tet = None; // the tetrahedron on it
  double area = 0;
  double cellHeight = 0; // of that tetrahedron above the face
  Vector3 normal;        // unit, into the fluid
  std::array<Index, 3> vertex{};
};

struct ColumnFoot
{
  Index point = None;
  int patch = 0;  // where several walls meet: the lowest number
  Vector3 normal; // unit, into the fluid: the mean of all wall faces at the point, weighted by area
  bool isSmooth = false;
  double wallEdge = 0; // mean length of the wall's edges at the point
};

// Of each triangle the face of a tetrahedron that it lies on, or None. Of those of sheets the one side's.
std::vector<HalfFace> innerFacesOf(const MeshData& mesh, const FaceMatching& matching);

// The triangles of patches with layers that lie on a tetrahedron. Point numbers must be in range.
std::vector<MeasuredWallFace> wallFacesOf(
  const MeshData& mesh, const std::vector<HalfFace>& innerFaces, const LayerPlan& plan);

// The points of these faces in order of number. A point is smooth where no face turns by smoothAngle
// (degrees) or more from the mean normal.
std::vector<ColumnFoot> columnFeetOf(
  const MeshData& mesh, const std::vector<MeasuredWallFace>& faces, double smoothAngle);
} // namespace ransmesh

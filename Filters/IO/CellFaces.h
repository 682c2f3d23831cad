// The faces of a cell, and what tells that two are the same.
#ifndef CellFaces_h
#define CellFaces_h

#include "MeshView.h"

#include <algorithm>
#include <cstdint>

namespace ransmesh
{
// Its points, in a sense that turns its normal out of the cell that it is a face of.
struct Face
{
  int count = 0;
  std::array<vtkIdType, 4> points;

  const vtkIdType* begin() const { return points.data(); }
  const vtkIdType* end() const { return points.data() + count; }
};

// Corners of the faces of a cell that is turned as MeshView turns it; -1 where a face has three.
struct FaceTable
{
  int count;
  std::array<std::array<signed char, 4>, 6> corners;
};

inline constexpr std::array<FaceTable, 4> FacesOfKind = { {
  { 4, { { { 0, 2, 1, -1 }, { 0, 1, 3, -1 }, { 1, 2, 3, -1 }, { 0, 3, 2, -1 } } } },
  { 5, { { { 0, 3, 2, 1 }, { 0, 1, 4, -1 }, { 1, 2, 4, -1 }, { 2, 3, 4, -1 }, { 3, 0, 4, -1 } } } },
  { 5, { { { 0, 2, 1, -1 }, { 3, 4, 5, -1 }, { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 2, 0, 3, 5 } } } },
  { 6,
    { { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 } } } },
} };

inline int facesOf(CellKind kind)
{
  return FacesOfKind[static_cast<int>(kind)].count;
}

inline Face faceOf(const Corners& cell, int number)
{
  const auto& corners = FacesOfKind[static_cast<int>(cell.kind)].corners[number];
  Face face;
  face.count = corners[3] < 0 ? 3 : 4;
  for (int i = 0; i < face.count; ++i)
  {
    face.points[i] = cell[corners[i]];
  }
  return face;
}

// The number of corners and the three smallest points: no two faces of a mesh share these.
struct FaceKey
{
  int count;
  std::array<vtkIdType, 3> smallest;

  bool operator==(const FaceKey&) const = default;
};

template <class AnyFace>
FaceKey keyOf(const AnyFace& face)
{
  std::array<vtkIdType, 4> p;
  std::copy(face.begin(), face.end(), p.begin());
  const auto order = [&p](int i, int j)
  {
    if (p[j] < p[i])
    {
      std::swap(p[i], p[j]);
    }
  };
  if (face.count == 4) // the largest goes last
  {
    order(0, 3);
    order(1, 3);
    order(2, 3);
  }
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return { face.count, { p[0], p[1], p[2] } };
}
} // namespace ransmesh

#endif

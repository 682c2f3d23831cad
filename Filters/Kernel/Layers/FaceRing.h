// The wall's faces around a point in order, and the edges between them.
#pragma once

#include "Boundary/BoundaryStars.h"
#include "Geometry/Angles.h"

#include <span>
#include <vector>

namespace ransmesh
{
// How the wall turns at the edge between two faces that follow each other around a point.
struct Turn
{
  double angle = 0; // between the normals, radians, 0 to pi
  bool isConvex = false;

  // The two faces are each other's opposite wall, and the gap between them closes at their edge.
  bool isWedge() const { return !isConvex && angle > LeastOfWedge; }
  static constexpr double LeastOfWedge = 150 / DegreesOfRadian;
};

struct FaceRing
{
  // Counterclockwise seen from the fluid: the edge that ends a face begins the next.
  std::vector<FaceAtVertex> faces;
  bool closed = false; // the last face ends where the first begins

  // The turn from face i to the next one (the first follows the last if closed).
  Turn turnAfter(const Vector3& point, const TetMesh& mesh, std::size_t i) const;
  std::size_t edgeCount() const { return closed ? faces.size() : faces.size() - 1; }
  // Rotates a closed ring so that it begins with face i.
  void beginWith(std::size_t i);
};

// Puts faces in order. False where they do not make one chain or ring.
bool makeRing(const std::vector<FaceAtVertex>& faces, FaceRing& ring);

// A run of faces of the ring, first to first + count - 1.
struct FaceGroup
{
  std::size_t first = 0;
  std::size_t count = 0;
  std::span<const FaceAtVertex> of(const FaceRing& ring) const { return { &ring.faces[first], count }; }
};

// The groups of faces between the edges that isBorder names (edge i lies behind face i). A closed ring is
// rotated so that its first group begins with the first face; with fewer than two borders it is one group.
template <class IsBorder>
std::vector<FaceGroup> splitRing(FaceRing& ring, IsBorder isBorder)
{
  std::vector<std::size_t> borders; // faces that end a group
  for (std::size_t i = 0; i < ring.edgeCount(); ++i)
  {
    if (isBorder(i))
    {
      borders.push_back(i);
    }
  }
  if (ring.closed && borders.size() < 2)
  {
    return { { 0, ring.faces.size() } };
  }
  if (ring.closed)
  {
    const std::size_t shift = (borders.back() + 1) % ring.faces.size();
    ring.beginWith(shift);
    for (std::size_t& b : borders)
    {
      b = (b + ring.faces.size() - shift) % ring.faces.size();
    }
  }
  else
  {
    borders.push_back(ring.faces.size() - 1);
  }
  std::vector<FaceGroup> groups;
  std::size_t begin = 0;
  for (const std::size_t b : borders)
  {
    groups.push_back({ begin, b + 1 - begin });
    begin = b + 1;
  }
  return groups;
}
} // namespace ransmesh

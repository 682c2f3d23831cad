// Walks on the triangles of adjoining patches, from the foot of a column.
#pragma once

#include "Boundary/BoundaryStars.h"
#include "Boundary/SurfaceNormals.h"
#include "Layers/SidePath.h"

#include <array>
#include <optional>

namespace ransmesh
{
enum class WalkEnd
{
  Reached,   // the height asked for
  Border,    // the patch ends, or a ridge of its own comes: an opposite surface
  Continued, // the patch ends, but the surface goes on under another name
  Bent,      // the surface turns away from the direction
  NoWay      // there is no triangle, or no ridge, in the direction
};

struct SideWay
{
  WalkEnd end = WalkEnd::NoWay;
  SidePath path;
};

// A column as the walk needs it.
struct SideStart
{
  Index vertex = None; // its foot
  std::array<int, 2> sides{ 0, 0 };
  Vector3 direction; // rises by one
  Vector3 up;        // dot(up, x - base) is the height of x; dot(up, direction) is 1
};

class SideWalk
{
public:
  SideWalk(const TetMesh& mesh, const BoundaryStars& stars, const SurfaceNormals& normals)
    : mesh_(mesh)
    , stars_(stars)
    , normals_(normals)
  {
  }

  // The way up to a height. With one side: the cut of its triangles with the plane of the direction and
  // the side's normal. With two: the ridge between them, edge by edge.
  SideWay follow(const SideStart& start, double reach) const;

private:
  // An edge that the way crosses, and the face that it leaves there: seen along the way, from right to left.
  struct Crossing
  {
    Index face;
    Index right;
    Index left;
  };
  struct CutPlane
  {
    Vector3 origin;
    Vector3 normal; // to the left
    bool isLeft(const Vector3& x) const { return dot(x - origin, normal) >= 0; }
    double distance(const Vector3& x) const { return dot(x - origin, normal); }
  };

  SideWay followSurface(const SideStart& start, double reach) const;
  SideWay followRidge(const SideStart& start, double reach) const;
  std::optional<Crossing> firstCrossing(const SideStart& start, CutPlane& plane) const;
  SidePath::Node nodeAt(const SideStart& start, const CutPlane& plane, const Crossing& crossing) const;
  SidePath::Node nodeAt(const SideStart& start, Index v, const std::array<Vector3, 2>& like) const;
  Index ridgeEdgeAt(const SideStart& start, Index v, Index from, const Vector3& along) const;
  bool ridgeNormals(const SideStart& start, Index v, Index w, std::array<Vector3, 2>& normals) const;
  Index faceBeyond(const Crossing& crossing) const;
  Vector3 normalOf(Index face) const;

  const TetMesh& mesh_;
  const BoundaryStars& stars_;
  const SurfaceNormals& normals_;
};
} // namespace ransmesh

// The surface as it was given: where remeshed points must lie.
#pragma once

#include "Remeshing/EditableSurface.h"
#include "Triangles/TriangleTree.h"

#include <map>
#include <vector>

namespace ransmesh
{
struct ReferencePoint
{
  Vector3 place;
  Vector3 normal;        // unit; of the triangle that the place lies on
  Index triangle = None; // of the given surface
};

struct LinePoint
{
  Vector3 place;
  double edge = 0; // length of the given line's edge there
};

// How far two surfaces are from each other, at the points and triangles' middles of both. In length units.
struct SurfaceDeviation
{
  double largest = 0;
  Vector3 place; // where it is largest
  double mean = 0;
};

class SurfaceReference
{
public:
  // Keeps a copy of the surface and of its feature lines.
  explicit SurfaceReference(const EditableSurface& given);
  SurfaceReference(const SurfaceReference&) = delete;
  SurfaceReference& operator=(const SurfaceReference&) = delete;

  const SurfaceMesh& surface() const { return surface_; }
  // The closest point on the triangles of a patch.
  ReferencePoint closestOnPatch(const Vector3& p, int patch) const;
  // The closest point on a line of feature edges.
  LinePoint closestOnLine(const Vector3& p, Index line) const;

private:
  static std::map<int, TriangleTree> treesOf(const SurfaceMesh& surface);

  SurfaceMesh surface_;
  SurfaceMesh lines_; // an edge is a triangle with its end twice, a line a patch
  std::vector<TriangleTree> lineTrees_;
  std::map<int, TriangleTree> trees_; // by patch
};

// The largest and the mean distance of the points, edges' and triangles' middles of each patch of `surface`
// from the same patch of `reference`.
SurfaceDeviation deviationFrom(const SurfaceReference& reference, const SurfaceMesh& surface);
} // namespace ransmesh

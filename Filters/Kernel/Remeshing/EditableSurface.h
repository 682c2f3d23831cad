// A triangulated surface whose triangles change: edges are split, collapsed and swapped.
#pragma once

#include "Triangles/SurfaceMesh.h"
#include "Triangles/SurfaceTriangles.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace ransmesh
{
// How a point may move.
enum class PointFreedom : std::uint8_t
{
  Surface, // anywhere on its patch
  Line,    // along the line of feature edges that it lies on
  Fixed    // not at all
};

// Feature edges are the borders of patches, edges where the surface turns by more than an angle, and those
// where not exactly two triangles meet. They make up lines, numbered from 0, that end where other than two
// feature edges meet or where two of them turn by more than the angle. Only this class changes triangles;
// it keeps the surface's topology, patches and lines.
class EditableSurface
{
public:
  // `angle` in degrees. Points with `keep` (a flag a point, or none) are fixed, and so are edges and
  // triangles between them.
  EditableSurface(SurfaceMesh surface, double angle, std::vector<char> keep = {});

  const SurfaceMesh& surface() const { return surface_; }
  // The surface without what has gone.
  SurfaceMesh result() const;

  std::size_t pointCount() const { return surface_.points.size(); }
  std::size_t triangleCount() const { return surface_.triangles.size(); }
  const Vector3& point(Index v) const { return surface_.points[v]; }
  const Corners& triangle(Index t) const { return surface_.triangles[t]; }
  int patch(Index t) const { return surface_.patch[t]; }
  bool isAlive(Index t) const { return surface_.triangles[t][0] != None; }
  const std::vector<Index>& trianglesAt(Index v) const { return trianglesAt_[v]; }
  PointFreedom freedom(Index v) const { return freedom_[v]; }
  // Those that share an edge with v, ascending.
  std::vector<Index> neighbours(Index v) const;
  // The triangles at an edge; the third corner of a triangle at it.
  std::vector<Index> trianglesAt(Index a, Index b) const;
  Index cornerOpposite(Index t, Index a, Index b) const;

  // The line that an edge belongs to, or None.
  Index lineOf(Index a, Index b) const;
  Index lineCount() const { return lineCount_; }
  // The neighbours of v along feature edges.
  std::vector<Index> neighboursOnLines(Index v) const;

  bool maySplit(Index a, Index b) const;
  // Puts a point on an edge; gives its number.
  Index split(Index a, Index b, const Vector3& place);

  // Whether point `gone` may be drawn into its neighbour `kept`, by topology and lines.
  bool mayCollapse(Index gone, Index kept) const;
  void collapse(Index gone, Index kept);

  // Whether the edge may be swapped, by topology and lines; then the two new triangles.
  bool maySwap(Index a, Index b, std::array<Corners, 2>& made) const;
  void swap(Index a, Index b);

  void move(Index v, const Vector3& place) { surface_.points[v] = place; }

private:
  void linkTriangles();
  void findFeatures(double cosine);
  void findFreedom(double angle);
  void nameLines();
  void nameLineFrom(Index from, Index to);
  bool isKept(Index v) const { return !keep_.empty() && v < static_cast<Index>(keep_.size()) && keep_[v]; }
  void addTriangle(const Corners& corners, int patch);
  void removeTriangle(Index t);
  void setFeature(Index a, Index b, Index line);

  SurfaceMesh surface_; // triangles that have gone have the corners None
  std::vector<char> keep_;
  std::vector<std::vector<Index>> trianglesAt_; // by point
  std::vector<PointFreedom> freedom_;
  std::unordered_map<std::uint64_t, Index> lineOf_; // of feature edges
  Index lineCount_ = 0;
};
} // namespace ransmesh

// The edges of a triangulated surface, each with all triangles that meet there.
#pragma once

#include "Triangles/SurfaceMesh.h"

#include <algorithm>
#include <tuple>

namespace ransmesh
{
// One side of one triangle; a < b.
struct SurfaceEdge
{
  Index a = None;
  Index b = None;
  Index triangle = None;
  bool forward = true; // the triangle runs from a to b

  bool sameEdge(const SurfaceEdge& other) const { return a == other.a && b == other.b; }
};

// Three entries a triangle, sorted so that the entries of one edge follow each other.
inline std::vector<SurfaceEdge> sortedEdges(const SurfaceMesh& surface)
{
  std::vector<SurfaceEdge> edges;
  edges.reserve(3 * surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Index from = surface.triangles[t][i];
      const Index to = surface.triangles[t][(i + 1) % 3];
      edges.push_back({ std::min(from, to), std::max(from, to), static_cast<Index>(t), from < to });
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const SurfaceEdge& x, const SurfaceEdge& y)
    { return std::tie(x.a, x.b, x.triangle) < std::tie(y.a, y.b, y.triangle); });
  return edges;
}

// Calls visit(first, last) for the entries of each edge.
template <class Visit>
void forEachEdge(const std::vector<SurfaceEdge>& edges, Visit visit)
{
  for (std::size_t first = 0; first < edges.size();)
  {
    std::size_t last = first + 1;
    while (last < edges.size() && edges[last].sameEdge(edges[first]))
    {
      ++last;
    }
    visit(edges.data() + first, edges.data() + last);
    first = last;
  }
}
} // namespace ransmesh

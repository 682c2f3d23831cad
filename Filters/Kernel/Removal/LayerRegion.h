// The region that the layers are going to fill, and the points in it.
#pragma once

#include "Boundary/Classification.h"
#include "Layers/LayerSpecification.h"
#include "Mesh/TetMesh.h"

#include <unordered_map>
#include <vector>

namespace ransmesh
{
struct LayerRegion
{
  // Points that are to go, neighbours soon after each other: free ones, and those on surfaces and ridges of
  // patches without layers. Corners and frozen points never are.
  std::vector<Index> marked;
  std::vector<char> isMarked; // by vertex
  // By marked vertex: the quality, at most 1, of a tetrahedron that reaches over the region from the wall
  // triangle nearby. Where the region is thick or the wall's triangles are stretched, no better can be
  // expected.
  std::vector<float> attainable;
  // Of marked points on the surfaces of walls (Removal/CornerRegion.h): the wall's normal there.
  std::unordered_map<Index, Vector3> wallNormal;
  // By marked vertex: how far the region reaches from its wall, a length scale of the elements to come.
  std::vector<float> reach;
};

// Marks what lies within the layers' thickness, limited by the local size, plus margin * size of a wall.
// Advances from the walls by layers of elements (section 6 of the paper), so that its cost is that of
// the region alone. The size is that of the wall's triangles.
LayerRegion findLayerRegion(const TetMesh& mesh, const BoundaryStars& stars,
  const Classification& classification, const std::vector<char>& changeable, const LayerPlan& plan,
  double margin);
} // namespace ransmesh

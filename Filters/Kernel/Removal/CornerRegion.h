// The points of walls that stand in the way of other walls' layers, at concave ridges.
#pragma once

#include "Boundary/Classification.h"
#include "Layers/LayerSpecification.h"
#include "Mesh/TetMesh.h"

#include <vector>

namespace ransmesh
{
struct CornerPoint
{
  Index vertex;
  double reach;   // how far the layers reach over the wall from the ridge
  Vector3 normal; // of the wall there, into the fluid; zero on a ridge
};

// Walls with layers that meet at a concave ridge (Layers/TensorCorner.h) need room for a grid of
// both walls' levels: on either wall, no point but the ridge's may lie lower above the other wall than its
// layers are thick, plus margin * size of the triangles there; layers that are thinner than the size need
// less, by the square of their share of it. Finds those that do: points on the walls'
// surfaces, and on ridges where they run into another wall. Frozen points and corners never are among them.
// changeable: by patch, whether a point on a ridge of that patch and a wall may go. Each point once.
std::vector<CornerPoint> findCornerPoints(const TetMesh& mesh, const BoundaryStars& stars,
  const Classification& classification, const std::vector<char>& changeable, const LayerPlan& plan,
  double margin);
} // namespace ransmesh

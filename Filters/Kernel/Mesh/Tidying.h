// The order that the data contract wants of a mesh's cells and points.
#pragma once

#include "Mesh/FaceMatching.h"
#include "Mesh/MeshData.h"

namespace ransmesh
{
// Triangles come sorted by patch number; those of one patch keep their order.
void sortByPatch(MeshData& mesh);

// Gives the corners of all cells their new numbers.
void renumberCorners(const std::vector<Index>& number, MeshData& mesh);

// Drops points that no tetrahedron uses; all triangles must be faces of tetrahedra.
void dropUnusedPoints(MeshData& mesh);

// Swaps two corners of boundary triangles that are turned inward; triangles off the boundary stay as they are.
void turnOutward(MeshData& mesh, const FaceMatching& matching);
} // namespace ransmesh

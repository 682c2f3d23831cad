// How well the layers keep to the heights asked for.
#pragma once

#include "Layers/LayerSpecification.h"
#include "Mesh/MeshData.h"

#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace chain_run
{
// By point of the mesh: the number of layers of the columns that a gap has limited, else -1. boundary: the
// second output of the enrichment.
std::vector<int> levelsInGaps(const ransmesh::MeshData& mesh, vtkPolyData* boundary);

// The share of the walls' area whose first tetrahedra are, within a tenth, as high as asked.
struct FirstHeightShares
{
  double ofAll = 0;
  double awayFromGaps =
    0; // of the triangles without a point whose column a gap has limited; 1 if there is none
};
FirstHeightShares firstHeightShares(
  const ransmesh::MeshData& mesh, const ransmesh::LayerPlan& plan, const std::vector<int>& inGaps);

// Of the smooth points of the walls, the share over which the mesh's edges make all layers asked for, or in
// gaps as many as these leave: found as the quality report does.
double columnsWithTheirLayers(
  const ransmesh::MeshData& mesh, const ransmesh::LayerPlan& plan, const std::vector<int>& inGaps);

// How far the ratio of a column's successive spacings is off the growth rate, as a share of it: 99 of 100 are nearer.
// Of several rates in the plan, the nearest. Along columns, by their numbers; those that share one with the points of a
// grid are left out.
double growthOff(const ransmesh::MeshData& mesh, vtkDataArray* column, const ransmesh::LayerPlan& plan);
} // namespace chain_run

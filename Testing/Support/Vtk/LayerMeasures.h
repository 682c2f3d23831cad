// How well the layers keep to the heights asked for.
#pragma once

#include "Layers/LayerSpecification.h"
#include "Mesh/MeshData.h"

class vtkDataArray;

namespace chain_run
{
// The share of the walls' area whose first tetrahedra are, within a tenth, as high as asked.
double areaWithFirstHeight(const ransmesh::MeshData& mesh, const ransmesh::LayerPlan& plan);

// How far the ratio of a column's successive spacings is off the growth rate, as a share of it: 99 of 100 are nearer.
// Of several rates in the plan, the nearest. Along columns, by their numbers; those that share one with the points of a
// grid are left out.
double growthOff(const ransmesh::MeshData& mesh, vtkDataArray* column, const ransmesh::LayerPlan& plan);
} // namespace chain_run

// What must hold after every enrichment.
#pragma once

#include "Insertion/Enrichment.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace enrichment_checks
{
using namespace ransmesh;

// Runs the stage and checks its invariants: validity, volume and patch areas (of plane-sided domains),
// the arrays' sizes, prisms of at most three tetrahedra, counts that add up.
EnrichedMesh enrichAndCheck(
  const MeshData& mesh, const PatchTable& patches, const LayerPlan& plan, double tolerance = 1e-9);

// The layers of one wall in a plan for so many patches.
LayerPlan planFor(std::size_t patches, const std::set<int>& walls, double firstHeight, int layers);

// The largest dihedral angle of the layers' tetrahedra, degrees; 0 without layers.
double largestLayerAngle(const EnrichedMesh& enriched);

// Are all layers complete, and are copies of the wall patch's triangles faces of the mesh at every level?
void expectCompleteLayers(const MeshData& input, const EnrichedMesh& enriched, int wall, int layers);
} // namespace enrichment_checks

// The layers made once more, point by point, as a reference.
#pragma once

#include "Insertion/Enrichment.h"

#include <array>
#include <map>

namespace enrichment_checks
{
using Corners = std::array<ransmesh::Index, 4>; // sorted

// Tetrahedra with their layers.
using LayerTets = std::map<Corners, int>;

// Those that the enrichment wrote.
LayerTets writtenLayers(const ransmesh::EnrichedMesh& enriched);

// Those that come into being when the points are inserted into what lies beyond the layers one at a time, from the
// outermost level to the wall: a point below a vertex of the boundary is joined to all boundary triangles around that
// vertex and takes its place in them. Left are the boundary's triangles at the end, sorted. Knows no stacks: only
// which points stand on each column. For walls without tensor grids.
LayerTets insertPointByPoint(
  const ransmesh::EnrichedMesh& enriched, std::vector<std::array<ransmesh::Index, 3>>& left);
} // namespace enrichment_checks

// Enriches a mesh that is cut open along its sheets, so that it can be put together again.
#pragma once

#include "Boundary/Sheets.h"
#include "Insertion/Enrichment.h"

namespace ransmesh
{
// As enrich, for an opened mesh and its patches as patchesOfOpened gives them; the two sides of each sheet come
// out alike (SheetFit.h). Where they do not, once more without tensor-product grids on sheets, which are all
// that divides their triangles.
Outcome enrichOpened(const MeshData& input, const OpenedSheets& opened, const PatchTable& patches,
  const LayerPlan& plan, const EnrichmentOptions& options, const Context& context, EnrichedMesh& result);

// opened: what openSheets said of the mesh that went into enrich. Afterwards columns on both sides of a sheet
// share their wall point, which has the number of one of them in `column` and two entries in wallPoints; and
// origin tells points of the mesh before it was opened. Leaves a mesh without sheets as it is. InternalFault
// where the two sides do not fit together.
Outcome closeSheets(const OpenedSheets& opened, EnrichedMesh& enriched);
} // namespace ransmesh

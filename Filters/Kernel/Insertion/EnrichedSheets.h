// Puts an enriched mesh together again that was cut open along its sheets.
#pragma once

#include "Boundary/Sheets.h"
#include "Insertion/Enrichment.h"

namespace ransmesh
{
// opened: what openSheets said of the mesh that went into enrich. Afterwards columns on both sides of a sheet
// share their wall point, which has the number of one of them in `column` and two entries in wallPoints; and
// origin tells points of the mesh before it was opened. Leaves a mesh without sheets as it is. InternalFault
// where the two sides do not fit together.
Outcome closeSheets(const OpenedSheets& opened, EnrichedMesh& enriched);
} // namespace ransmesh

// The enriched mesh as VTK data.
#ifndef EnrichmentOutput_h
#define EnrichmentOutput_h

#include "Insertion/Enrichment.h"
#include "Support/Patch.h"

class vtkPointData;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace ransmesh
{
// The mesh with PatchId, LayerId, PrismId, ColumnId, and the point data of the input carried over.
void writeEnrichedMesh(const EnrichedMesh& enriched, const PatchTable& patches, vtkPointData* inputData,
  vtkUnstructuredGrid* grid);

// The boundary with what was asked for and achieved at each wall point.
void writeEnrichedBoundary(const EnrichedMesh& enriched, const PatchTable& patches, vtkPolyData* boundary);
} // namespace ransmesh

#endif

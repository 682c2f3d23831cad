// A quality report as VTK data.
#ifndef QualityOutput_h
#define QualityOutput_h

#include "Quality/QualityReport.h"

class vtkPolyData;
class vtkTable;
class vtkUnstructuredGrid;

namespace ransmesh
{
// Adds the measures to the grid from which the mesh was read, as cell arrays.
void addCellArrays(const CellMeasures& cells, vtkUnstructuredGrid* grid);

// Quantity, Value, Unit, Scope.
void writeSummary(const QualityReport& report, vtkTable* table);

// Histogram, Quantity, Scope, BinLow, BinHigh, Count.
void writeHistograms(const QualityReport& report, vtkTable* table);

// LayerId of each tetrahedron in order; empty if the grid has none.
std::vector<int> readLayerIds(vtkUnstructuredGrid* grid);

// What the enrichment's boundary output says about columns that stopped early; empty if it says nothing.
std::vector<StopCount> countStops(vtkPolyData* boundary);
} // namespace ransmesh

#endif

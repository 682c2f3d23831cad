// A quality report as VTK data.
#ifndef QualityOutput_h
#define QualityOutput_h

#include "QualityInput.h"

#include "Quality/QualityReport.h"

class vtkPolyData;
class vtkTable;
class vtkUnstructuredGrid;

namespace ransmesh
{
// Adds the measures to the grid from which the input was read, as cell arrays.
void addCellArrays(const CellMeasures& cells, const QualityInput& input, vtkUnstructuredGrid* grid);

// Quantity, Value, Unit, Scope.
void writeSummary(const QualityReport& report, vtkTable* table);

// Histogram, Quantity, Scope, BinLow, BinHigh, Count.
void writeHistograms(const QualityReport& report, vtkTable* table);

// What the enrichment's boundary output says about columns that stopped early; empty if it says nothing.
std::vector<StopCount> countStops(vtkPolyData* boundary);
} // namespace ransmesh

#endif

// What the filters of this module tell, as tables.
#pragma once

#include "Surface/Diagnosis.h"
#include "Surface/DiagnosisText.h"
#include "Surface/Repair.h"

class vtkTable;

namespace ransmesh
{
// Kind, Count, Triangles, Patches, X, Y, Z.
void writeFaults(const std::vector<FaultRow>& rows, vtkTable* table);
// Piece, Triangles, OpenEdges, Area, Volume, EnclosedBy, Patches, XMin ... ZMax.
void writePieces(const std::vector<SurfacePiece>& pieces, const PatchTable& patches, vtkTable* table);
// Repair, Count, X, Y, Z.
void writeRepairs(const std::vector<Repair>& repairs, vtkTable* table);
} // namespace ransmesh

// The poly data that the inputs consist of.
#pragma once

#include "Support/Outcome.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace ransmesh
{
struct SurfacePiece
{
  vtkSmartPointer<vtkPolyData> data; // triangles only
  std::string name;                  // of the block, or empty
};

// Takes composite data apart, names the pieces by their blocks, and triangulates. Pieces without
// polygons are left out. BadInput where a block is not poly data.
Outcome collectPieces(const std::vector<vtkDataObject*>& inputs, std::vector<SurfacePiece>& pieces);
} // namespace ransmesh

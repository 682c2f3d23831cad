// From VTK's surfaces to one triangulated surface with patches.
#pragma once

#include "Support/Outcome.h"
#include "Support/Patch.h"
#include "Triangles/SurfaceMesh.h"

#include "RANSMeshingCoreModule.h"

#include <vector>

class vtkDataObject;

namespace ransmesh
{
struct SurfaceInput
{
  SurfaceMesh surface; // points not merged yet
  SurfaceMesh sheets;  // likewise
  PatchTable patches;
  std::vector<char> isSheet;    // by patch number
  std::vector<int> wholePieces; // patches that are all of an input piece, for want of anything finer
  std::vector<std::string> remarks;
};

// Reads poly data and composite data of them; polygons and strips are triangulated. The patch of a cell
// is found in the order of the data contract: the array PatchId; an array that another tool has left;
// else each piece is one patch. Numbers that PatchId gives are kept where they are unique; all others
// follow in the order of the input. Names come from PatchNames, else from the block's name and the
// number. Types come from PatchTypes, else from the names.
// Sheets are read in the same way, into patches of their own; where nothing tells, they are named wake and
// of type wake.
RANSMESHINGCORE_EXPORT Outcome readSurface(const std::vector<vtkDataObject*>& surfaces,
  const std::vector<vtkDataObject*>& sheets, SurfaceInput& result);
} // namespace ransmesh

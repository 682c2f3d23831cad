// Sheets as the kernel sees them: it works on a mesh that is cut open along its sheets, so that each is two
// walls back to back, and puts it together again afterwards.
#pragma once

#include "Mesh/MeshData.h"
#include "Support/Outcome.h"

#include <string>
#include <vector>

namespace ransmesh
{
struct OpenedSheets
{
  std::vector<int> patches; // that are sheets, ascending; empty: the mesh was left as it is
  // Of each point of the opened mesh: the point of the closed one that it is, that it is a copy of, or that a
  // new one lies next to.
  std::vector<Index> origin;

  bool any() const { return !patches.empty(); }
  Index originOf(Index v) const { return any() ? origin[v] : v; }
};

// Cuts a valid mesh open along its sheets, if it has any: each point of a sheet gets a copy for each further
// side, and each triangle becomes two boundary triangles of the same patch, turned away from each other, the
// second behind all others. Points on the free border of a sheet stay one. Where an edge or a triangle would
// not fall apart (both ends lie on the border), it is divided before: the sheet keeps its shape and gets one
// point more. BadInput, with the place, where rounding does not allow that; the mesh is not to be used then.
Outcome openSheets(MeshData& mesh, OpenedSheets& opened);

// The reverse, for a mesh on whose sheets no point moved, came or went: points with equal coordinates on
// these patches become one, and so do the pairs of triangles; which keeps the way that the first is turned.
// newNumber receives the number of each point. InternalFault where a triangle has lost its partner.
Outcome closeSheets(MeshData& mesh, const std::vector<int>& sheetPatches, std::vector<Index>& newNumber);
} // namespace ransmesh

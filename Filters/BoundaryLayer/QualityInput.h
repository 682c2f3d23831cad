// A mesh as the quality report reads it: tetrahedra as they are, prisms cut into tetrahedra.
#ifndef QualityInput_h
#define QualityInput_h

#include "Mesh/MeshData.h"
#include "Quality/QualityReport.h"
#include "Support/Outcome.h"
#include "Support/Patch.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace ransmesh
{
struct QualityInput
{
  MeshData mesh;
  PatchTable patches;
  std::vector<int> layerIds; // of each tetrahedron; empty if the grid has none
  std::vector<int> regions;  // likewise
  std::map<int, std::string> regionNames;
  std::vector<Index> tetCell;         // the grid's cell that each tetrahedron is, or is cut from
  std::vector<Index> triangleCell;    // the same of each triangle
  std::optional<PrismSummary> prisms; // of a mesh with prisms
};

// BadInput as readMesh and readMixedMesh say it.
Outcome readQualityInput(vtkUnstructuredGrid* grid, QualityInput& input);
} // namespace ransmesh

#endif

// Names as OpenFOAM takes them, and the files of zones in a polyMesh folder, which are of text: OpenFOAM
// takes it beside binary files.
#ifndef FoamZones_h
#define FoamZones_h

#include "FoamFaces.h"

#include <string>
#include <vector>

namespace ransmesh::foam
{
std::vector<std::string> foamLabels(std::vector<BoundaryPatch> patches);
std::vector<std::string> foamLabels(std::vector<Region> regions);

// Face zones: patches inside the mesh that are internal faces; labels: of all patches. Cell zones: regions, where there
// are several. No file where there are none. The system's number of the first error, or 0.
int writeFaceZones(const MeshView& mesh, const std::vector<std::string>& labels,
  const std::vector<ZoneFace>& faces, const std::string& path);
int writeCellZones(const MeshView& mesh, const std::string& path);
} // namespace ransmesh::foam

#endif

// What edges surfaces are to have, as users say it: by patterns of patches and arrays of points.
#ifndef SurfaceSizing_h
#define SurfaceSizing_h

#include "Remeshing/SurfaceRemeshing.h"
#include "Support/Outcome.h"
#include "Support/Patch.h"

#include "RANSMeshingCoreModule.h"

#include <string>
#include <utility>
#include <vector>

class vtkDataObject;

namespace ransmesh
{
struct SurfaceSizing
{
  RemeshingOptions general;
  // Patches by a name, a name with the wildcards * and ?, or a number; later rules win.
  std::vector<std::pair<std::string, double>> lengthOfPattern;
  std::vector<std::pair<Vector3, double>> lengthAtPoint;

  bool isWanted() const { return general.isWanted() || !lengthOfPattern.empty() || !lengthAtPoint.empty(); }
};

// Reads the largest edges that a point array of surfaces asks for; 0 and less ask for none. BadInput where no
// surface has the array.
RANSMESHINGCORE_EXPORT Outcome readLengthsAtPoints(
  const std::vector<vtkDataObject*>& surfaces, const std::string& array, SurfaceSizing& sizing);

// The options for a surface: patterns become patch numbers; where nothing is wanted of other patches, these
// are kept, and those of type interface are in any case. BadInput where a pattern takes no patch.
RANSMESHINGCORE_EXPORT Outcome remeshingOptions(const SurfaceSizing& sizing, const PatchTable& patches,
  const SurfaceMesh& surface, RemeshingOptions& options);

// What remeshing did, in a sentence for the user.
RANSMESHINGCORE_EXPORT std::string textOf(const RemeshingReport& report);
} // namespace ransmesh

#endif

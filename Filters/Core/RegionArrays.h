// Regions in a grid's arrays: RegionId of its cells, RegionNames in its field data.
#ifndef RegionArrays_h
#define RegionArrays_h

#include "Mesh/MeshData.h"

#include "RANSMeshingCoreModule.h"

#include <string>
#include <vector>

class vtkFieldData;
class vtkUnstructuredGrid;

namespace ransmesh
{
// The number of each tetrahedron's region, or of those of the cells given. Empty where the grid has none: no array
// RegionId of whole numbers of 1 and more.
RANSMESHINGCORE_EXPORT std::vector<int> readRegions(vtkUnstructuredGrid* grid);
RANSMESHINGCORE_EXPORT std::vector<int> readRegions(
  vtkUnstructuredGrid* grid, const std::vector<Index>& cells);

// Adds the array, 0 on all cells behind the tetrahedra, which come first. None for an empty list.
RANSMESHINGCORE_EXPORT void writeRegions(const std::vector<int>& ofTets, vtkUnstructuredGrid* grid);

// What a region is called: its row of RegionNames, else `<fluid>_<number>`.
RANSMESHINGCORE_EXPORT std::string regionName(vtkFieldData* fieldData, int number, const std::string& fluid);

// Replaces RegionNames; the name at 0 is no region's.
RANSMESHINGCORE_EXPORT void writeRegionNames(const std::vector<std::string>& names, vtkFieldData* fieldData);

// Regions that there were and are no longer, in words for the user; empty if there are none.
RANSMESHINGCORE_EXPORT std::string lostRegions(const std::vector<int>& before, const std::vector<int>& now);
} // namespace ransmesh

#endif

// Surfaces from files: .stl .obj .ply .vtp, also gzipped.
#pragma once

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkPolyData;

namespace surfaces
{
// Whether the name ends as those of surface files do.
bool isSurfaceFile(const std::string& path);

// The surface of all files together, with the cell array PatchId and the field data PatchNames. STL
// solids and OBJ groups are patches; a file without them, or with one only, is a patch named by the
// file's stem. Where a name comes in several files, it is preceded by the stem. A .vtp file keeps
// its PatchId, PatchNames and PatchTypes. Throws std::runtime_error with the file's name.
vtkSmartPointer<vtkPolyData> readSurfaces(const std::vector<std::string>& paths);
} // namespace surfaces

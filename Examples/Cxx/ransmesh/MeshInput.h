// Meshes of tetrahedra that other programs made, from files.
#pragma once

#include <vtkSmartPointer.h>

#include <string>

class vtkDataObject;

namespace commandline
{
// Whether the name ends as those of mesh files do: .msh (gmsh), .vtu, .vtk, .cgns.
bool isMeshFile(const std::string& path);

// Data sets, or blocks of them, as VTK's readers give them. Throws std::runtime_error with the file's name.
vtkSmartPointer<vtkDataObject> readMesh(const std::string& path);
} // namespace commandline

// Files that are there whole or not at all.
#pragma once

#include <string>

class vtkPolyData;
class vtkUnstructuredGrid;

namespace commandline
{
// Throws std::runtime_error where no file can be made there; asked before the work begins.
void checkWritable(const std::string& path);

// Is that the name of a mesh for a solver: .su2, polyMesh and so on?
bool isSolverMesh(const std::string& path);
// Can a file of that name hold sheets: wakes, walls without thickness?
bool canHoldSheets(const std::string& path);

// Write under another name, then rename. Throw std::runtime_error; nothing is left behind then.
void writeMesh(vtkUnstructuredGrid* mesh, const std::string& path, bool leaveOutSheets);
void writeSurface(vtkPolyData* surface, const std::string& path);
void writeText(const std::string& text, const std::string& path);
} // namespace commandline

// The surfaces that the benchmarks mesh.
#pragma once

#include <vtkSmartPointer.h>

#include <string>

class vtkPolyData;

namespace ransmesh_benchmarks
{
// A closed box of 1 x 1 x 0.25 with a wall for floor, of n x n x n / 4 squares cut in two.
vtkSmartPointer<vtkPolyData> plate(int n);

// A sphere of radius 0.5: an icosahedron whose triangles are cut in four, level times.
vtkSmartPointer<vtkPolyData> sphere(int level);

// The hull of a ship: nullptr where its file is not there. The environment variable RANSMESHING_HULL names
// another file.
vtkSmartPointer<vtkPolyData> hull();
std::string hullFile();
bool hullIsThere();
} // namespace ransmesh_benchmarks

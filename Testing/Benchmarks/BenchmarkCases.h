// The bodies that the benchmarks mesh, with their layers and the speed that the enrichment is to reach.
#pragma once

#include <vtkSmartPointer.h>

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace ransmesh_benchmarks
{
struct CaseDescription
{
  std::string name;
  std::function<vtkSmartPointer<vtkPolyData>()> surface;
  double leastRatio = 0;          // that the enrichment's rate is to be of CGAL's; 0: no goal
  bool farField = false;          // the mesher puts a box around the body
  std::vector<std::string> walls; // patterns; none: all patches of type wall
  double firstHeight = 1e-5;
  int layers = 25;
};

// All cases whose surface is there; those left out are named on standard output. Files of bodies are looked for
// in the folder that the environment variable RANSMESHING_GEOMETRY names.
std::vector<CaseDescription> benchmarkCases();
} // namespace ransmesh_benchmarks

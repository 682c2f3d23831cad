#include "BenchmarkSurfaces.h"

#include "Bodies/Blocks.h"
#include "Bodies/Rounds.h"
#include "Vtk/BodyPolyData.h"

#ifdef RANSMESHING_READS_SURFACES
#include "SurfaceReader.h"
#endif

#include <vtkPolyData.h>

#include <cstdlib>
#include <filesystem>

namespace ransmesh_benchmarks
{
vtkSmartPointer<vtkPolyData> plate(int n)
{
  return bodies::toPolyData(bodies::plate(1.0 / n));
}

vtkSmartPointer<vtkPolyData> sphere(int level)
{
  return bodies::toPolyData(bodies::sphere(1 << level));
}

std::string hullFile()
{
  const char* chosen = std::getenv("RANSMESHING_HULL");
  return chosen ? chosen : RANSMESHING_HULL;
}

bool hullIsThere()
{
#ifdef RANSMESHING_READS_SURFACES
  return std::filesystem::exists(hullFile());
#else
  return false;
#endif
}

vtkSmartPointer<vtkPolyData> hull()
{
#ifdef RANSMESHING_READS_SURFACES
  return hullIsThere() ? surfaces::readSurfaces({ hullFile() }) : nullptr;
#else
  return nullptr;
#endif
}
} // namespace ransmesh_benchmarks

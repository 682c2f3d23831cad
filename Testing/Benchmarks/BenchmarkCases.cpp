#include "BenchmarkCases.h"

#include "Bodies/Blocks.h"
#include "Bodies/Rounds.h"
#include "Bodies/Wings.h"
#include "Vtk/BodyPolyData.h"

#ifdef RANSMESHING_READS_SURFACES
#include "SurfaceReader.h"
#endif

#include <vtkPolyData.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace ransmesh_benchmarks
{
namespace
{
// Ratios to CGAL's rate.
constexpr double ThinGoal = 12;
constexpr double ThickGoal = 6;
constexpr double RealGoal = 5;
constexpr double TensorGoal = 4;

constexpr int ThickLayers = 40;
constexpr double Growth = 1.2;

CaseDescription made(const char* name, bodies::Body (*make)(), double leastRatio)
{
  CaseDescription c;
  c.name = name;
  c.surface = [make] { return bodies::toPolyData(make()); };
  c.leastRatio = leastRatio;
  c.farField = make().farField;
  return c;
}

// The same with layers half as thick again as the wall's triangles are long.
CaseDescription thick(CaseDescription c, double size)
{
  c.name += "-thick";
  c.leastRatio = ThickGoal;
  c.layers = ThickLayers;
  c.firstHeight = 1.5 * size * (Growth - 1) / (std::pow(Growth, ThickLayers) - 1);
  return c;
}

std::string fileOf(const char* name)
{
  const char* chosen = std::getenv("RANSMESHING_GEOMETRY");
  return std::string(chosen ? chosen : RANSMESHING_GEOMETRY) + "/" + name;
}

void addFromFile(CaseDescription c, const char* name, std::vector<CaseDescription>& cases)
{
#ifdef RANSMESHING_READS_SURFACES
  if (std::filesystem::exists(fileOf(name)))
  {
    c.surface = [file = fileOf(name)] { return surfaces::readSurfaces({ file }); };
    cases.push_back(c);
    return;
  }
#endif
  std::printf("The case %s is left out: there is no %s (RANSMESHING_GEOMETRY names another folder).\n",
    c.name.c_str(), fileOf(name).c_str());
}

void addSmooth(std::vector<CaseDescription>& cases)
{
  const CaseDescription plate = made(
    "plate", [] { return bodies::plate(0.01); }, ThinGoal);
  const CaseDescription sphere = made(
    "sphere", [] { return bodies::sphere(32); }, ThinGoal);
  const CaseDescription pipe = made(
    "pipe", [] { return bodies::pipe(0.025); }, ThinGoal);
  cases.insert(cases.end(), { plate, sphere, pipe });
  cases.insert(cases.end(), { thick(plate, 0.01), thick(sphere, 0.017), thick(pipe, 0.025) });
}
} // namespace

std::vector<CaseDescription> benchmarkCases()
{
  std::vector<CaseDescription> cases;
  cases.push_back(made(
    "tiny", [] { return bodies::plate(0.125); }, 0));
  cases.back().firstHeight = 1e-4;
  cases.back().layers = 5;
  addSmooth(cases);
  cases.push_back(made(
    "cavity-six", [] { return bodies::cavity(0.02, true); }, TensorGoal));
  cases.push_back(made(
    "wing", [] { return bodies::wing(0.03, bodies::TrailingEdge::Sharp, bodies::Tip::Flat); }, RealGoal));
  CaseDescription hull;
  hull.name = "hull";
  hull.leastRatio = ThinGoal;
  hull.farField = true;
  addFromFile(hull, "dtc_hull.obj.gz", cases);
  CaseDescription aircraft;
  aircraft.name = "aircraft";
  aircraft.leastRatio = RealGoal;
  aircraft.walls = { "aircraft_*" };
  aircraft.firstHeight = 1.2e-2;
  addFromFile(aircraft, "dlrf6_halfdomain.obj.gz", cases);
  return cases;
}
} // namespace ransmesh_benchmarks

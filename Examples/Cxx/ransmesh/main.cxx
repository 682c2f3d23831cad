// ransmesh: from surface files to a mesh file, for those who script.
// Exit status: 0 a valid mesh was written; 1 the input cannot be meshed; 2 wrong usage.
#include "Chain.h"
#include "MeshFile.h"
#include "MeshInput.h"
#include "Options.h"
#include "ReportFile.h"
#include "SurfaceReader.h"

#include <vtkLogger.h>
#include <vtkMeshQualityReport.h>
#include <vtkPolyData.h>
#include <vtkRANSLayerAlgorithm.h>
#include <vtkUnstructuredGrid.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <memory>

namespace
{
using namespace commandline;

constexpr int Done = 0;
constexpr int CannotMesh = 1;
constexpr int WrongUsage = 2;

void printError(const std::string& text)
{
  std::fprintf(stderr, "ransmesh: %s\n", text.c_str());
}

void checkFiles(const Options& options)
{
  for (const std::string& path : { options.output, options.report, options.problems })
  {
    if (!path.empty())
    {
      checkWritable(path);
    }
  }
}

void printWarnings(const Options& options, const Chain& chain)
{
  if (options.quiet)
  {
    return;
  }
  if (options.threads > 1)
  {
    std::fputs("ransmesh: --threads has no effect yet: every stage runs on one thread\n", stderr);
  }
  for (const std::string& warning : chain.warnings())
  {
    std::fprintf(stderr, "ransmesh: warning: %s\n", warning.c_str());
  }
}

// What follows from the flow conditions, before the long work begins.
void printFlow(const Options& options, vtkRANSLayerAlgorithm& layers)
{
  if (!options.quiet && options.flow.isGiven() && layers.GetEstimatedFirstHeight() > 0)
  {
    std::printf(
      "Flow: Re %.4g, Cf %.4g (%s), u_tau %.4g%s, first height %.4g for y+ %g, boundary layer %.4g\n"
      "Layers: %d, %.4g thick\n",
      layers.GetEstimatedReynoldsNumber(), layers.GetEstimatedSkinFriction(),
      frictionLaws()[frictionLawOf(options.flow)].c_str(), layers.GetEstimatedFrictionVelocity(),
      options.flow.velocity > 0 ? " m/s" : " U", layers.GetEstimatedFirstHeight(), layers.GetYPlus(),
      layers.GetEstimatedBoundaryLayerThickness(), layers.GetPlannedNumberOfLayers(),
      layers.GetPlannedTotalThickness());
    std::fflush(stdout);
  }
}

void writeResults(const Options& options, const Chain& chain)
{
  const std::string report = options.report.empty() ? "" : reportOf(options, chain, "");
  if (!report.empty())
  {
    writeText(report, options.report);
  }
  writeMesh(chain.mesh(), options.output, options.leaveOutSheets); // last: where it is, all is
  if (!options.quiet)
  {
    std::printf("%s\n%s: %lld points, %lld cells\n", chain.report()->GetReportText(), options.output.c_str(),
      static_cast<long long>(chain.mesh()->GetNumberOfPoints()),
      static_cast<long long>(chain.mesh()->GetNumberOfCells()));
  }
}

void keepProblems(const Options& options, const Chain* chain)
{
  if (!options.problems.empty() && chain && chain->problems()->GetNumberOfCells() > 0)
  {
    writeSurface(chain->problems(), options.problems);
  }
}

int mesh(const Options& options)
{
  std::unique_ptr<Chain> chain;
  std::string error;
  try
  {
    const vtkSmartPointer<vtkDataObject> input = options.isMesh()
      ? readMesh(options.surfaces.front())
      : vtkSmartPointer<vtkDataObject>(surfaces::readSurfaces(options.surfaces));
    vtkSmartPointer<vtkPolyData> sheets;
    if (!options.wakes.empty())
    {
      sheets = surfaces::readSurfaces(options.wakes);
    }
    chain = std::make_unique<Chain>(options, input, sheets);
    printFlow(options, *chain->layers());
    chain->run();
    printWarnings(options, *chain);
    writeResults(options, *chain);
    return Done;
  }
  catch (const std::bad_alloc&)
  {
    error = "there is not enough memory";
  }
  catch (const std::exception& caught)
  {
    error = caught.what();
  }
  printError(error);
  try
  {
    keepProblems(options, chain.get());
    if (!options.report.empty())
    {
      writeText(chain ? reportOf(options, *chain, error) : reportOf(options, error), options.report);
    }
  }
  catch (const std::exception& caught)
  {
    printError(caught.what());
  }
  return CannotMesh;
}
} // namespace

int main(int count, char* words[])
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // the filters' remarks; errors are told by us
  try
  {
    const Options options = parseOptions({ words + 1, words + count });
    if (options.help || options.version)
    {
      std::fputs(options.help ? helpText().c_str() : "ransmesh " RANSMESHING_VERSION "\n", stdout);
      return Done;
    }
    checkFiles(options);
    Progress::catchInterrupts();
    std::signal(SIGXFSZ, SIG_IGN); // beyond a limit on files writing fails, and says so
    return mesh(options);
  }
  catch (const UsageError& error)
  {
    printError(std::string(error.what()) + " (ransmesh --help tells the options)");
    return WrongUsage;
  }
  catch (const std::runtime_error& error) // of checkFiles
  {
    printError(error.what());
    return CannotMesh;
  }
}

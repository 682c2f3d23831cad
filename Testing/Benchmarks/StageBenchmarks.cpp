// Prints, for each case, the speed and the memory of each stage, of TetGen on the same surface, and of
// CGAL's Delaunay insertion of the same final points. Rates of stages in this process are by processor
// time; TetGen's is by the processor time of its process.
#include "BenchmarkSurfaces.h"
#include "CgalInsertion.h"
#include "Chain.h"
#include "PeakMemory.h"

#include "Quality/QualityReport.h"

#include <benchmark/benchmark.h>

#include <ctime>
#include <list>

namespace
{
using namespace ransmesh_benchmarks;
using benchmark::Counter;

void setRate(benchmark::State& state, const char* name, std::size_t count)
{
  state.counters[name] = Counter(static_cast<double>(count), Counter::kIsIterationInvariantRate);
}

void setBytesPerTet(benchmark::State& state, std::size_t bytes, std::size_t tets)
{
  if (bytes > 0 && tets > 0)
  {
    state.counters["bytes/tet"] = static_cast<double>(bytes) / static_cast<double>(tets);
  }
}

double processorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void runMesher(benchmark::State& state, Chain& chain)
{
  const PeakMemory memory;
  const double before = secondsOfChildren();
  const std::size_t childBefore = peakOfChildren();
  for (auto _ : state)
  {
    chain.mesh();
  }
  const std::size_t tets = chain.isotropic().tetrahedra.size();
  const double seconds = secondsOfChildren() - before;
  setRate(state, "tets/s", tets);
  state.counters["tets"] = static_cast<double>(tets);
  if (seconds > 0)
  {
    state.counters["TetGen_tets/s"] =
      static_cast<double>(tets) * static_cast<double>(state.iterations()) / seconds;
  }
  // The larger of the two processes; TetGen's is known only if no earlier case needed more.
  const std::size_t child = peakOfChildren() > childBefore ? peakOfChildren() : 0;
  setBytesPerTet(state, std::max(child, memory.bytes()), tets);
}

void runRemoval(benchmark::State& state, Chain& chain)
{
  ransmesh::RemovalResult result;
  std::size_t tets = chain.isotropic().tetrahedra.size();
  const PeakMemory memory;
  for (auto _ : state)
  {
    state.PauseTiming();
    ransmesh::TetMesh mesh = chain.editableIsotropic();
    state.ResumeTiming();
    result = chain.remove(mesh);
    state.PauseTiming();
    setBytesPerTet(state, memory.bytes(), tets);
    chain.keepCleared(mesh);
    state.ResumeTiming();
  }
  setRate(state, "points/s", result.marked);
  state.counters["marked"] = static_cast<double>(result.marked);
  state.counters["points"] = static_cast<double>(result.removed);
  state.counters["left"] = static_cast<double>(result.remaining.size());
  state.counters["tets"] = static_cast<double>(tets);
}

void runEnrichment(benchmark::State& state, Chain& chain)
{
  chain.cleared();
  const PeakMemory memory;
  const double begin = processorSeconds();
  for (auto _ : state)
  {
    chain.enrich();
  }
  const double seconds = (processorSeconds() - begin) / static_cast<double>(state.iterations());
  const ransmesh::EnrichmentReport& report = chain.enriched().report;
  const std::size_t tets = chain.enriched().mesh.tetrahedra.size();
  setBytesPerTet(state, memory.bytes(), tets);
  setRate(state, "points/s", report.pointsInserted);
  setRate(state, "tets/s", report.layerTets);
  state.counters["points"] = static_cast<double>(report.pointsInserted);
  state.counters["left"] = static_cast<double>(report.pointsRequested - report.pointsInserted);
  state.counters["tets"] = static_cast<double>(tets);
  chain.enrichmentRate = static_cast<double>(report.pointsInserted) / std::max(seconds, 1e-9);
}

void runCgal(benchmark::State& state, Chain& chain)
{
  const std::vector<ransmesh::Vector3>& points = chain.enriched().mesh.points;
  const PeakMemory memory;
  const double begin = processorSeconds();
  std::size_t tets = 0;
  for (auto _ : state)
  {
    tets = insertByCgal(points);
  }
  const double seconds = (processorSeconds() - begin) / static_cast<double>(state.iterations());
  setBytesPerTet(state, memory.bytes(), tets);
  setRate(state, "points/s", points.size());
  setRate(state, "tets/s", tets);
  state.counters["points"] = static_cast<double>(points.size());
  state.counters["tets"] = static_cast<double>(tets);
  const double rate = static_cast<double>(points.size()) / std::max(seconds, 1e-9);
  state.counters["enrichment/CGAL"] = chain.enrichmentRate / rate;
}

void runQuality(benchmark::State& state, Chain& chain)
{
  const ransmesh::EnrichedMesh& enriched = chain.enriched();
  const ransmesh::ReportSubject subject{ enriched.mesh, chain.patches(), chain.plan(), &enriched.layer };
  const PeakMemory memory;
  ransmesh::QualityReport report;
  for (auto _ : state)
  {
    report = ransmesh::reportQuality(subject, {}, {});
  }
  setBytesPerTet(state, memory.bytes(), report.tetrahedra);
  setRate(state, "tets/s", report.tetrahedra);
  state.counters["tets"] = static_cast<double>(report.tetrahedra);
  if (!report.isValid)
  {
    state.SkipWithError(("the mesh is not valid: " + report.faults.text()).c_str());
  }
}

using Run = void (*)(benchmark::State&, Chain&);

void add(const char* stage, Run run, Chain& chain, bool byWallClock)
{
  auto* entry = benchmark::RegisterBenchmark((std::string(stage) + "/" + chain.name()).c_str(),
    [run, &chain](benchmark::State& state)
    {
      try
      {
        run(state, chain);
      }
      catch (const std::exception& error)
      {
        state.SkipWithError(error.what());
      }
    });
  entry->Iterations(1)->Unit(benchmark::kMillisecond);
  if (byWallClock)
  {
    entry->UseRealTime();
  }
}

void addCase(Chain& chain)
{
  add("Mesher", runMesher, chain, true); // works in another process
  add("Removal", runRemoval, chain, false);
  add("Enrichment", runEnrichment, chain, false);
  add("CgalDelaunay", runCgal, chain, false);
  add("Quality", runQuality, chain, false);
}
} // namespace

int main(int argc, char** argv)
{
  std::list<Chain> cases;
  cases.emplace_back(CaseDescription{ "tiny", [] { return plate(8); }, false, 1e-4, 5 });
  cases.emplace_back(CaseDescription{ "plate", [] { return plate(100); }, false });
  cases.emplace_back(CaseDescription{ "sphere", [] { return sphere(5); }, true });
  if (hullIsThere())
  {
    cases.emplace_back(CaseDescription{ "hull", hull, true });
  }
  else
  {
    std::printf("The case hull is left out: there is no %s (RANSMESHING_HULL names another file).\n",
      hullFile().c_str());
  }
  for (Chain& chain : cases)
  {
    addCase(chain);
  }
  std::vector<char*> arguments(argv, argv + argc);
  std::string tabular = "--benchmark_counters_tabular=true";
  arguments.insert(arguments.begin() + 1, tabular.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data()))
  {
    return 2;
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

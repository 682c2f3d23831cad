// Prints, for each case, the speed and the memory of each stage, of TetGen on the same surface, and of
// CGAL's Delaunay insertion of the same final points. Rates of stages in this process are by processor
// time; TetGen's is by the processor time of its process.
#include "BenchmarkCases.h"
#include "CgalInsertion.h"
#include "Chain.h"
#include "PeakMemory.h"

#include "Quality/QualityReport.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <list>
#include <vector>

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

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void runEnrichment(benchmark::State& state, Chain& chain)
{
  chain.cleared();
  const PeakMemory memory;
  std::vector<double> seconds;
  for (auto _ : state)
  {
    const double begin = processorSeconds();
    chain.enrich();
    seconds.push_back(processorSeconds() - begin);
  }
  const ransmesh::EnrichmentReport& report = chain.enriched().report;
  const std::size_t tets = chain.enriched().mesh.tetrahedra.size();
  setBytesPerTet(state, memory.bytes(), tets);
  const double inserted = static_cast<double>(report.pointsInserted);
  state.counters["points/s"] = inserted / median(seconds);
  state.counters["tets/s"] = static_cast<double>(report.layerTets) / median(seconds);
  state.counters["points"] = inserted;
  state.counters["left"] = static_cast<double>(report.pointsRequested - report.pointsInserted);
  state.counters["tets"] = static_cast<double>(tets);
  chain.figures.enrichmentRate = inserted / median(seconds);
  chain.figures.enrichmentBytes = static_cast<double>(memory.bytes()) / static_cast<double>(tets);
}

void runFilter(benchmark::State& state, Chain& chain)
{
  const double inserted = static_cast<double>(chain.enriched().report.pointsInserted);
  std::vector<double> seconds;
  for (auto _ : state)
  {
    seconds.push_back(chain.runEnrichmentFilter());
  }
  state.counters["points/s"] = inserted / median(seconds);
  chain.figures.filterRate = inserted / median(seconds);
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
  chain.figures.cgalRate = static_cast<double>(points.size()) / seconds;
  state.counters["enrichment/CGAL"] = chain.figures.enrichmentRate / chain.figures.cgalRate;
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

struct Stage
{
  const char* name;
  Run run;
  int repetitions;  // of which the middle one counts
  bool byWallClock; // works in another process
};

constexpr Stage Stages[] = { { "Mesher", runMesher, 1, true }, { "Removal", runRemoval, 1, false },
  { "Enrichment", runEnrichment, 5, false }, { "EnrichmentFilter", runFilter, 3, false },
  { "CgalDelaunay", runCgal, 1, false }, { "Quality", runQuality, 1, false } };

void add(const Stage& stage, Chain& chain)
{
  auto* entry = benchmark::RegisterBenchmark((std::string(stage.name) + "/" + chain.name()).c_str(),
    [run = stage.run, &chain](benchmark::State& state)
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
  entry->Iterations(stage.repetitions)->Unit(benchmark::kMillisecond);
  if (stage.byWallClock)
  {
    entry->UseRealTime();
  }
}

// One line: the ratio that the enrichment is judged by.
void printRatio(const Chain& chain)
{
  const Chain::Figures& f = chain.figures;
  if (f.enrichmentRate == 0 || f.cgalRate == 0)
  {
    return;
  }
  const double ratio = f.enrichmentRate / f.cgalRate;
  std::printf("ratio %-13s %5.2f", chain.name().c_str(), ratio);
  if (const double goal = chain.description().leastRatio; goal > 0)
  {
    std::printf(" (goal %g: %s)", goal, ratio >= goal ? "reached" : "missed");
  }
  std::printf(
    ": enrichment %.3f M points/s, with conversions %.3f M, CGAL %.3f M; memory %.0f bytes/tetrahedron\n",
    f.enrichmentRate / 1e6, f.filterRate / 1e6, f.cgalRate / 1e6, f.enrichmentBytes);
}
} // namespace

int main(int argc, char** argv)
{
  std::list<Chain> cases;
  for (const CaseDescription& description : benchmarkCases())
  {
    cases.emplace_back(description);
  }
  for (Chain& chain : cases)
  {
    for (const Stage& stage : Stages)
    {
      add(stage, chain);
    }
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
  std::for_each(cases.begin(), cases.end(), printRatio);
  return 0;
}

#include "TetGenWorker.h"

#include "TemporaryFolder.h"
#include "WorkerProcess.h"

#include "Support/Numbers.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace ransmesh
{
namespace
{
struct Phase
{
  std::string_view line; // how TetGen announces it
  double fraction;       // of the run's time that has passed then
  const char* name;
};
constexpr std::array<Phase, 7> Phases = { {
  { "Delaunizing", 0.01, "connecting points" },
  { "Creating surface mesh", 0.04, "inserting the surface" },
  { "Recovering boundaries", 0.06, "recovering the surface" },
  { "Removing exterior", 0.16, "removing the outside" },
  { "Refining mesh", 0.20, "refining" },
  { "Optimizing mesh", 0.85, "improving quality" },
  { "Writing nodes", 0.97, "writing" },
} };
constexpr double RefiningBegins = 0.20;
constexpr double RefiningEnds = 0.85;

// What the context was told last, to tell it again while TetGen is silent: that lets a user's interface act.
struct Progress
{
  double fraction = 0;
  const char* phase = "meshing";
};

// The final number of points is not known: progress nears the end of the phase as points come in.
void readLine(const std::string& line, double pointsBefore, Progress& progress)
{
  if (line.rfind(worker::ProgressMark, 0) == 0)
  {
    const double points = std::strtod(line.c_str() + std::strlen(worker::ProgressMark), nullptr);
    const double added = std::max(0.0, points - pointsBefore);
    const double share = added / (added + 2 * pointsBefore + 1);
    progress = { RefiningBegins + share * (RefiningEnds - RefiningBegins), "refining" };
    return;
  }
  for (const Phase& phase : Phases)
  {
    if (line.rfind(phase.line, 0) == 0)
    {
      progress = { phase.fraction, phase.name };
    }
  }
}

const char* meaningOf(int tetgenCode)
{
  switch (tetgenCode)
  {
    case 2:
      return "an internal error of TetGen";
    case 3:
      return "parts of the surface cross, or come nearer to each other than it can tell apart";
    case 4:
      return "a feature of the surface is too small for it";
    case 5:
      return "two parts of the surface are too close to each other";
    case 10:
      return "it does not accept the surface";
    default:
      return "an unknown error";
  }
}

bool ranOutOfMemory(const ProgramEnd& end)
{
  constexpr int tetGensCode = 1;
  return end.status == worker::ExitMemory || end.status == worker::ExitTetGen + tetGensCode;
}

std::string describe(const ProgramEnd& end, const WorkerLimits& limits)
{
  std::string text;
  if (end.kind == ProgramEnd::Kind::TimedOut)
  {
    text = "TetGen was stopped at the time limit of " + textOf(limits.seconds) + " s (WorkerTimeLimit)";
  }
  else if (ranOutOfMemory(end))
  {
    text = limits.megabytes > 0
      ? "TetGen needs more memory than the limit of " + std::to_string(static_cast<long>(limits.megabytes)) +
        " MB (WorkerMemoryLimit): raise it, or ask for fewer elements"
      : "the TetGen worker ran out of memory: ask for fewer elements";
  }
  else if (end.status == worker::ExitEndless)
  {
    return "TetGen refined without end, as badly shaped surface triangles make it: set SurfaceEdgeLength to "
           "remesh the surface";
  }
  else if (end.status == worker::ExitStalled)
  {
    text = "TetGen does not come to an end with the surface, as it happens where facets lie almost in a "
           "plane: move or turn the surface a little, or set SurfaceEdgeLength to remesh it";
  }
  else if (end.status > worker::ExitTetGen && end.status <= worker::ExitTetGen + 10)
  {
    const int code = end.status - worker::ExitTetGen;
    text = "TetGen gave up with error " + std::to_string(code) + ": " + meaningOf(code);
  }
  else
  {
    text = "the TetGen worker failed: " + end.how;
  }
  return end.lastWords.empty() ? text : text + "; its last words:\n" + end.lastWords;
}
} // namespace

TetGenEnd TetGenWorker::run(worker::Request& request, const Context& context, worker::Result& result) const
{
  const TemporaryFolder folder;
  const std::string requestFile = folder.file("request");
  const std::string resultFile = folder.file("result");
  if (!folder.ok() || !worker::save(request, requestFile))
  {
    return { Outcome::internalFault("cannot write temporary files: set TMPDIR to a folder with free space") };
  }
  const auto pointsBefore = static_cast<double>(request.points.size() / 3);
  Progress progress;
  const auto onLine = [&](const std::string& line) { readLine(line, pointsBefore, progress); };
  const auto mustStop = [&]
  {
    context.report(progress.fraction, progress.phase);
    return context.stopped();
  };
  const ProgramEnd end = runProgram(
    { program_, requestFile, resultFile, std::to_string(static_cast<long long>(limits_.megabytes)) },
    limits_.seconds, mustStop, onLine);
  if (end.kind == ProgramEnd::Kind::Cancelled)
  {
    return { Outcome::cancelled() };
  }
  if (end.kind != ProgramEnd::Kind::Done)
  {
    return { Outcome::badInput(describe(end, limits_)), end.status == worker::ExitEndless,
      ranOutOfMemory(end) };
  }
  if (!worker::load(result, resultFile))
  {
    return { Outcome::internalFault("the TetGen worker '" + program_ +
      "' left no readable result: is it of the same version as this library?" +
      (end.lastWords.empty() ? "" : " Its last words:\n" + end.lastWords)) };
  }
  return { Outcome::done() };
}
} // namespace ransmesh

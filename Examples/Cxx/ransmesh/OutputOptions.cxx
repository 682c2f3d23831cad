#include "Arguments.h"
#include "MeshFile.h"

namespace commandline
{
namespace
{
void check(const Options& options)
{
  if (options.output.empty())
  {
    throw UsageError("no mesh file is given: add -o MESH.vtu");
  }
  if (!endsWith(options.output, ".vtu") && !isSolverMesh(options.output))
  {
    throw UsageError(
      "-o writes .vtu, .su2, .cgns, .msh, .ugrid and .foam files and folders named polyMesh, not " +
      options.output);
  }
  if (!options.wakes.empty() && !options.leaveOutSheets && !canHoldSheets(options.output))
  {
    throw UsageError(options.output +
      " cannot hold the faces of --wake: leave them out of the file with "
      "--leave-out-sheets, or write a polyMesh, .cgns, .msh or .vtu");
  }
  if (!options.problems.empty() && !endsWith(options.problems, ".vtp"))
  {
    throw UsageError("--problems writes .vtp files only, not " + options.problems);
  }
}
} // namespace

const OptionGroup& outputOptions()
{
  using O = Options;
  using A = Arguments;
  using S = const std::string;
  static const OptionGroup group = {
    {
      { "-o", [](O& o, A& a, S& name) { o.output = a.valueOf(name); } },
      { "--leave-out-sheets", [](O& o, A&, S&) { o.leaveOutSheets = true; } },
      { "--report", [](O& o, A& a, S& name) { o.report = a.valueOf(name); } },
      { "--problems", [](O& o, A& a, S& name) { o.problems = a.valueOf(name); } },
      { "--threads", [](O& o, A& a, S& name) { o.threads = countOf(a, name); } },
      { "--quiet", [](O& o, A&, S&) { o.quiet = true; } },
      { "--help", [](O& o, A&, S&) { o.help = true; } },
      { "-h", [](O& o, A&, S&) { o.help = true; } },
      { "--version", [](O& o, A&, S&) { o.version = true; } },
    },
    check, R"(
Reports
  --report FILE.json    what was asked for, what came out, times, quality
  --problems FILE.vtp   where the surface cannot be meshed: keep the offending triangles
  --threads N           accepted; has no effect yet: every stage runs on one thread
  --quiet               print nothing but errors
  --version, --help
)"
  };
  return group;
}
} // namespace commandline

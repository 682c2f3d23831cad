#include "Options.h"

#include "SurfaceReader.h"

#include <charconv>
#include <cmath>
#include <functional>
#include <map>

namespace commandline
{
namespace
{
// The arguments that have not been read yet.
class Arguments
{
public:
  explicit Arguments(const std::vector<std::string>& words)
    : words_(words)
  {
  }

  bool atEnd() const { return at_ == words_.size(); }
  bool atValue() const { return !atEnd() && (words_[at_].empty() || words_[at_][0] != '-'); }
  const std::string& next() { return words_[at_++]; }
  bool atNumber() const
  {
    double ignored = 0;
    return !atEnd() && parseWhole(words_[at_], ignored);
  }

  const std::string& valueOf(const std::string& option)
  {
    if (!atValue() && !atNumber())
    {
      throw UsageError(option + " needs a value");
    }
    return next();
  }

  template <typename Number>
  static bool parseWhole(const std::string& word, Number& number)
  {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    return error == std::errc() && end == word.data() + word.size();
  }

private:
  const std::vector<std::string>& words_;
  std::size_t at_ = 0;
};

double finiteNumber(const std::string& word, const std::string& option)
{
  double value = 0;
  if (!Arguments::parseWhole(word, value) || !std::isfinite(value))
  {
    throw UsageError(option + " needs a number, not \"" + word + "\"");
  }
  return value;
}

double angleOf(Arguments& arguments, const std::string& option, double most)
{
  const std::string& word = arguments.valueOf(option);
  const double value = finiteNumber(word, option);
  if (value < 0 || value > most)
  {
    throw UsageError(
      option + " must lie between 0 and " + std::to_string(static_cast<int>(most)) + ", not " + word);
  }
  return value;
}

double lengthOf(Arguments& arguments, const std::string& option, double atLeast = 0)
{
  const std::string& word = arguments.valueOf(option);
  const double value = finiteNumber(word, option);
  if (value <= 0 || value < atLeast)
  {
    throw UsageError(option +
      (atLeast > 0 ? " must be at least " + std::to_string(static_cast<int>(atLeast))
                   : std::string(" must be above 0")) +
      ", not " + word);
  }
  return value;
}

int countOf(Arguments& arguments, const std::string& option)
{
  const std::string& word = arguments.valueOf(option);
  int value = 0;
  if (!Arguments::parseWhole(word, value) || value < 1)
  {
    throw UsageError(option + " needs a whole number above 0, not \"" + word + "\"");
  }
  return value;
}

// One or more values, up to the next option.
std::vector<std::string> valuesOf(Arguments& arguments, const std::string& option)
{
  std::vector<std::string> values = { arguments.valueOf(option) };
  while (arguments.atValue())
  {
    values.push_back(arguments.next());
  }
  return values;
}

using Reader = std::function<void(Options&, Arguments&, const std::string&)>;

const std::map<std::string, Reader>& readers()
{
  using O = Options;
  using A = Arguments;
  using S = const std::string;
  static const std::map<std::string, Reader> table = {
    { "-o", [](O& o, A& a, S& name) { o.output = a.valueOf(name); } },
    { "--far-field", [](O& o, A& a, S& name) { o.farField = lengthOf(a, name); } },
    { "--wake", [](O& o, A& a, S& name) { o.wakes = valuesOf(a, name); } },
    { "--size", [](O& o, A& a, S& name) { o.size = lengthOf(a, name); } },
    { "--surface-size", [](O& o, A& a, S& name) { o.surfaceSize = lengthOf(a, name); } },
    { "--swap-angle", [](O& o, A& a, S& name) { o.swapAngle = angleOf(a, name, 90); } },
    { "--walls", [](O& o, A& a, S& name) { o.walls = valuesOf(a, name); } },
    { "--first-height", [](O& o, A& a, S& name) { o.firstHeight = lengthOf(a, name); } },
    { "--growth", [](O& o, A& a, S& name) { o.growth = lengthOf(a, name, 1); } },
    { "--layers", [](O& o, A& a, S& name) { o.layers = countOf(a, name); } },
    { "--thickness", [](O& o, A& a, S& name) { o.thickness = lengthOf(a, name); } },
    { "--isotropic-only", [](O& o, A&, S&) { o.isotropicOnly = true; } },
    { "--report", [](O& o, A& a, S& name) { o.report = a.valueOf(name); } },
    { "--problems", [](O& o, A& a, S& name) { o.problems = a.valueOf(name); } },
    { "--threads", [](O& o, A& a, S& name) { o.threads = countOf(a, name); } },
    { "--quiet", [](O& o, A&, S&) { o.quiet = true; } },
    { "--help", [](O& o, A&, S&) { o.help = true; } },
    { "-h", [](O& o, A&, S&) { o.help = true; } },
    { "--version", [](O& o, A&, S&) { o.version = true; } },
  };
  return table;
}

bool endsWith(const std::string& text, const std::string& end)
{
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

void checkTogether(const Options& options)
{
  if (options.surfaces.empty())
  {
    throw UsageError("no surface file is given");
  }
  for (const auto* files : { &options.surfaces, &options.wakes })
  {
    for (const std::string& file : *files)
    {
      if (!surfaces::isSurfaceFile(file))
      {
        throw UsageError(file + ": surfaces are read from .stl, .obj, .ply and .vtp files, also gzipped");
      }
    }
  }
  if (options.output.empty())
  {
    throw UsageError("no mesh file is given: add -o MESH.vtu");
  }
  if (!endsWith(options.output, ".vtu"))
  {
    throw UsageError("-o writes .vtu files only, not " + options.output);
  }
  if (!options.problems.empty() && !endsWith(options.problems, ".vtp"))
  {
    throw UsageError("--problems writes .vtp files only, not " + options.problems);
  }
  if (options.layers > 0 && options.thickness > 0)
  {
    throw UsageError("--layers and --thickness: give one of them, the other follows");
  }
  const bool layersDescribed = options.firstHeight > 0 || options.growth > 0 || options.layers > 0 ||
    options.thickness > 0 || !options.walls.empty();
  if (options.isotropicOnly && layersDescribed)
  {
    throw UsageError("--isotropic-only makes no layers: leave out what describes them");
  }
  if (!options.isotropicOnly && options.firstHeight == 0)
  {
    throw UsageError("--first-height is missing: the first spacing normal to the walls, in the unit of the "
                     "surface (or --isotropic-only for a mesh without layers)");
  }
}
} // namespace

Options parseOptions(const std::vector<std::string>& words)
{
  Options options;
  Arguments arguments(words);
  while (!arguments.atEnd())
  {
    if (arguments.atValue())
    {
      options.surfaces.push_back(arguments.next());
      continue;
    }
    const std::string& name = arguments.next();
    const auto reader = readers().find(name);
    if (reader == readers().end())
    {
      throw UsageError("there is no option " + name);
    }
    reader->second(options, arguments, name);
  }
  if (!options.help && !options.version)
  {
    checkTogether(options);
  }
  return options;
}

std::string helpText()
{
  return R"(Usage: ransmesh SURFACE... -o MESH.vtu [option...]

Meshes the space that triangulated surfaces bound, with stretched layers on viscous walls.
Lengths are in the unit of the surfaces.

  SURFACE...            .stl .obj .ply .vtp, also gzipped; STL solids and OBJ groups are patches;
                        several files are several patches, named by file
  -o MESH.vtu           the mesh: tetrahedra and boundary triangles (ParaView, VTK)

Domain
  --far-field M         a box around the bodies, M body lengths on each side;
                        without it the surfaces themselves bound the domain
  --wake FILE...        sheets inside the domain: wakes, walls without thickness; layers grow on
                        both sides; goes on to the next option
  --size L              largest edge in the field
  --surface-size L      size to which surfaces are remeshed (default: kept)
  --swap-angle A        very obtuse surface triangles are improved by swaps that turn the surface by at
                        most A degrees (10), and by points on their sides; 0: all triangles are kept

Layers
  --first-height H      first spacing normal to the walls; must be given
  --growth G            ratio of successive spacings (1.2)
  --layers N            number of layers (25)
  --thickness T         thickness of all layers; their number follows
  --walls PATTERN...    the viscous walls by patch name, * and ? allowed (every patch that is
                        not a side of a box); goes on to the next option
  --isotropic-only      stop after the first stage: no layers

Reports
  --report FILE.json    what was asked for, what came out, times, quality
  --problems FILE.vtp   where the surface cannot be meshed: keep the offending triangles
  --threads N           accepted; has no effect yet: every stage runs on one thread
  --quiet               print nothing but errors
  --version, --help

Exit status: 0 a valid mesh was written; 1 the input cannot be meshed, one line says why and
where, and no mesh file is written; 2 wrong usage.

Example: ransmesh body.stl -o mesh.vtu --far-field 5 --first-height 1e-5
)";
}
} // namespace commandline

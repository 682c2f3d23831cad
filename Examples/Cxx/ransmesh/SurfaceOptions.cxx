#include "Arguments.h"

#include "SurfaceReader.h"

namespace commandline
{
namespace
{
void checkSurfaces(const std::vector<std::string>& files)
{
  for (const std::string& file : files)
  {
    if (!surfaces::isSurfaceFile(file))
    {
      throw UsageError(file +
        ": surfaces are read from .stl, .obj, .ply and .vtp files, also gzipped; meshes "
        "from .msh, .vtu, .vtk and .cgns files");
    }
  }
}

// A mesh that is there already takes nothing that shapes one.
void checkMesh(const Options& options)
{
  if (options.surfaces.size() > 1)
  {
    throw UsageError(options.surfaces.front() + " is a mesh: give it alone");
  }
  if (!options.wakes.empty() || options.remesh.isGiven() || options.swapAngle >= 0 ||
    options.repair.wrapAlpha > 0)
  {
    throw UsageError(
      "options for surfaces have no meaning: " + options.surfaces.front() + " is a mesh already");
  }
}

// L or PATCH=L.
void addSize(Options& options, Arguments& arguments, const std::string& name)
{
  const std::string& word = arguments.valueOf(name);
  const std::size_t equals = word.rfind('=');
  const double length = finiteNumber(equals == std::string::npos ? word : word.substr(equals + 1), name);
  if (length <= 0 || equals == 0)
  {
    throw UsageError(name + " must be above 0, or PATCH=LENGTH, not " + word);
  }
  if (equals == std::string::npos)
  {
    options.remesh.length = length;
    return;
  }
  options.remesh.ofPatch.emplace_back(word.substr(0, equals), length);
}

void check(const Options& options)
{
  if (options.surfaces.empty())
  {
    throw UsageError("no surface file is given");
  }
  checkSurfaces(options.wakes);
  options.isMesh() ? checkMesh(options) : checkSurfaces(options.surfaces);
}
} // namespace

const OptionGroup& surfaceOptions()
{
  using O = Options;
  using A = Arguments;
  using S = const std::string;
  static const OptionGroup group = {
    {
      { "--wake", [](O& o, A& a, S& name) { addValues(a, name, o.wakes); } },
      { "--surface-size", addSize },
      { "--edges-per-circle", [](O& o, A& a, S& name) { o.remesh.edgesPerCircle = positiveOf(a, name); } },
      { "--edges-across-gap", [](O& o, A& a, S& name) { o.remesh.edgesAcrossGap = positiveOf(a, name); } },
      { "--smallest-size", [](O& o, A& a, S& name) { o.remesh.smallest = positiveOf(a, name); } },
      { "--surface-deviation", [](O& o, A& a, S& name) { o.remesh.deviation = positiveOf(a, name); } },
      { "--size-array", [](O& o, A& a, S& name) { o.remesh.array = a.valueOf(name); } },
      { "--swap-angle", [](O& o, A& a, S& name) { o.swapAngle = numberBetween(a, name, 0, 90); } },
    },
    check, R"(
Surfaces
  --wake FILE...        sheets inside the domain: wakes, walls without thickness; layers grow on
                        both sides; goes on to the next option
  --surface-size L|PATCH=L
                        size to which surfaces are remeshed (default: kept), for all or one patch (* and ?
                        allowed); may be given several times
  --edges-per-circle N  surfaces are remeshed so that a circle of their curvature has N edges
  --edges-across-gap N  surfaces are remeshed so that N edges fit in gaps of the fluid
  --smallest-size L     these two ask for no smaller edges (a hundredth of the largest)
  --surface-deviation L how far remeshed triangles may lie from the surface (a twentieth of an edge)
  --size-array NAME     surfaces are remeshed to the sizes of this point array
  --swap-angle A        very obtuse surface triangles are improved by swaps that turn the surface by at
                        most A degrees (10), and by points on their sides; 0: all triangles are kept
)"
  };
  return group;
}
} // namespace commandline

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
  if (!options.wakes.empty() || options.surfaceSize > 0 || options.swapAngle >= 0 ||
    options.repair.wrapAlpha > 0)
  {
    throw UsageError(
      "options for surfaces have no meaning: " + options.surfaces.front() + " is a mesh already");
  }
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
      { "--wake", [](O& o, A& a, S& name) { o.wakes = valuesOf(a, name); } },
      { "--surface-size", [](O& o, A& a, S& name) { o.surfaceSize = positiveOf(a, name); } },
      { "--swap-angle", [](O& o, A& a, S& name) { o.swapAngle = angleOf(a, name, 90); } },
    },
    check, R"(
Surfaces
  --wake FILE...        sheets inside the domain: wakes, walls without thickness; layers grow on
                        both sides; goes on to the next option
  --surface-size L      size to which surfaces are remeshed (default: kept)
  --swap-angle A        very obtuse surface triangles are improved by swaps that turn the surface by at
                        most A degrees (10), and by points on their sides; 0: all triangles are kept
)"
  };
  return group;
}
} // namespace commandline

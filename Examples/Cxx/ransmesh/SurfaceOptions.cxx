#include "Arguments.h"

#include "SurfaceReader.h"

namespace commandline
{
namespace
{
void check(const Options& options)
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

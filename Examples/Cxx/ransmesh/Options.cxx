#include "Options.h"

#include "Arguments.h"
#include "MeshInput.h"

namespace commandline
{
namespace
{
std::vector<const OptionGroup*> groups()
{
  return { &surfaceOptions(), &repairOptions(), &domainOptions(), &layerOptions(), &flowOptions(),
    &outputOptions() };
}

const Reader& readerOf(const std::string& name)
{
  for (const OptionGroup* group : groups())
  {
    if (const auto found = group->readers.find(name); found != group->readers.end())
    {
      return found->second;
    }
  }
  throw UsageError("there is no option " + name);
}
} // namespace

bool Options::isMesh() const
{
  return !surfaces.empty() && isMeshFile(surfaces.front());
}

Options parseOptions(const std::vector<std::string>& words)
{
  Options options;
  options.words = words;
  Arguments arguments(words);
  while (!arguments.atEnd())
  {
    if (arguments.atValue())
    {
      options.surfaces.push_back(arguments.next());
      continue;
    }
    const std::string& name = arguments.next();
    readerOf(name)(options, arguments, name);
  }
  if (!options.help && !options.version)
  {
    for (const OptionGroup* group : groups())
    {
      group->check(options);
    }
  }
  return options;
}

std::string helpText()
{
  std::string text = R"(Usage: ransmesh SURFACE... -o MESH.vtu [option...]

Meshes the space that triangulated surfaces bound, with stretched layers on viscous walls.
Lengths are in the unit of the surfaces.

  SURFACE...            .stl .obj .ply .vtp, also gzipped; STL solids and OBJ groups are patches;
                        several files are several patches, named by file;
                        or one mesh of tetrahedra, .msh (gmsh) .vtu .vtk .cgns, which gets layers as it is
  -o MESH               the mesh, for whom its name's end says: .vtu ParaView and VTK; .su2 SU2; .cgns CGNS;
                        .msh gmsh 2.2; .b8.ugrid, .lb8.ugrid, .ugrid FUN3D and AFLR3, with .mapbc;
                        a folder named polyMesh, or CASE.foam beside the folder constant, OpenFOAM
  --leave-out-sheets    leave out the faces of --wake where such a file cannot hold them
)";
  for (const OptionGroup* group : groups())
  {
    text += group->help;
  }
  text += R"(
Exit status: 0 a valid mesh was written; 1 the input cannot be meshed, one line says why and
where, and no mesh file is written; 2 wrong usage.

Example: ransmesh body.stl -o mesh.vtu --far-field 5 --first-height 1e-5
)";
  return text;
}
} // namespace commandline

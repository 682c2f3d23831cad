#include "FoamZones.h"

#include "PatchLabels.h"

#include <algorithm>

namespace ransmesh::foam
{
namespace
{
constexpr std::string_view Allowed = "_-.+:";

// OpenFOAM takes what begins with a digit or a sign for a number.
template <class Named>
void takeNumbersForNames(std::vector<Named>& things, const char* before)
{
  for (Named& thing : things)
  {
    if (std::string_view("0123456789+-.").find(thing.name[0]) != std::string_view::npos)
    {
      thing.name.insert(0, before);
    }
  }
}

void writeFaceZone(OutputFile& file, const BoundaryPatch& patch, const std::string& label,
  const std::vector<ZoneFace>& zoneFaces)
{
  std::vector<ZoneFace> faces;
  std::copy_if(zoneFaces.begin(), zoneFaces.end(), std::back_inserter(faces),
    [&patch](const ZoneFace& f)
    { return f.viewFace >= patch.first && f.viewFace < patch.first + patch.count(); });
  file.text(label).text("\n{\n    type            faceZone;\n    faceLabels      List<label> ");
  LabelList labels(file, false, static_cast<vtkIdType>(faces.size()));
  std::for_each(faces.begin(), faces.end(), [&labels](const ZoneFace& f) { labels.add(f.label); });
  file.text(");\n    flipMap         List<bool> ");
  LabelList flips(file, false, static_cast<vtkIdType>(faces.size()));
  std::for_each(faces.begin(), faces.end(), [&flips](const ZoneFace& f) { flips.add(f.flipped); });
  file.text(");\n}\n");
}

void writeCellZone(OutputFile& file, const MeshView& mesh, std::size_t region, const std::string& label)
{
  file.text(label).text("\n{\n    type            cellZone;\n    cellLabels      List<label> ");
  LabelList labels(file, false, mesh.regions()[region].count());
  for (vtkIdType c = 0; c < mesh.numberOfCells(); ++c)
  {
    if (mesh.regionOf(c) == region)
    {
      labels.add(c);
    }
  }
  file.text(");\n}\n");
}
} // namespace

std::vector<std::string> foamLabels(std::vector<BoundaryPatch> patches)
{
  takeNumbersForNames(patches, "patch_");
  return patchLabels(patches, Allowed);
}

std::vector<std::string> foamLabels(std::vector<Region> regions)
{
  takeNumbersForNames(regions, "region_");
  return regionLabels(regions, Allowed);
}

int writeFaceZones(const MeshView& mesh, const std::vector<std::string>& labels,
  const std::vector<ZoneFace>& faces, const std::string& path)
{
  if (faces.empty())
  {
    return 0;
  }
  OutputFile file(path);
  file.text(header("faceZones", "regIOobject", false));
  const auto& patches = mesh.patches();
  const auto isZone = [](const BoundaryPatch& p) { return FaceOrder::sidesOf(p) == 0; };
  file.number(std::count_if(patches.begin(), patches.end(), isZone)).text("\n(\n");
  for (std::size_t i = 0; i < patches.size(); ++i)
  {
    if (isZone(patches[i]))
    {
      writeFaceZone(file, patches[i], labels[i], faces);
    }
  }
  file.text(")\n");
  file.close();
  return file.error();
}

int writeCellZones(const MeshView& mesh, const std::string& path)
{
  if (mesh.regions().size() < 2)
  {
    return 0;
  }
  const std::vector<std::string> labels = foamLabels(mesh.regions());
  OutputFile file(path);
  file.text(header("cellZones", "regIOobject", false));
  file.number(labels.size()).text("\n(\n");
  for (std::size_t r = 0; r < labels.size(); ++r)
  {
    writeCellZone(file, mesh, r, labels[r]);
  }
  file.text(")\n");
  file.close();
  return file.error();
}
} // namespace ransmesh::foam

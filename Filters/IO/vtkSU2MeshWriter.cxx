// The format: https://su2code.github.io/docs_v7/Mesh-File/
#include "vtkSU2MeshWriter.h"

#include "MeshView.h"
#include "OutputFile.h"
#include "ReplacedPath.h"
#include "SU2Zones.h"

#include "vtkCellType.h"
#include "vtkObjectFactory.h"

#include <map>

vtkStandardNewMacro(vtkSU2MeshWriter);

namespace
{
using namespace ransmesh;

constexpr std::array<int, 6> SU2Types = { VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON, VTK_TRIANGLE,
  VTK_QUAD };

// The option of SU2's configuration that patches of a type belong in, and what stands there after a name.
struct Option
{
  const char* name;
  const char* values;
};

Option optionFor(PatchType type)
{
  switch (type)
  {
    case PatchType::Wall:
      return { "MARKER_HEATFLUX", ", 0.0" };
    case PatchType::Symmetry:
      return { "MARKER_SYM", "" };
    case PatchType::FarField:
      return { "MARKER_FAR", "" };
    case PatchType::Inlet:
      return { "MARKER_INLET", ", <temperature>, <velocity>, <x>, <y>, <z>" };
    case PatchType::Outlet:
      return { "MARKER_OUTLET", ", <pressure>" };
    default:
      return { "", "" };
  }
}

class SU2File
{
public:
  SU2File(const MeshView& mesh, const SU2Zones& zones, const std::string& path)
    : mesh_(mesh)
    , zones_(zones)
    , file_(path)
  {
  }

  int write()
  {
    const bool several = zones_.size() > 1;
    if (several)
    {
      writeInterfaces();
      file_.text("NZONE= ").number(zones_.size()).text("\n");
    }
    for (std::size_t z = 0; z < zones_.size(); ++z)
    {
      const SU2Zone zone = zones_.zone(z);
      if (several)
      {
        file_.text("IZONE= ").number(z + 1).text("\n% Zone ").text(zone.label).text("\n");
      }
      writeTypes(zone);
      writeCells(zone);
      writePoints(zone);
      writeMarkers(zone);
    }
    file_.close();
    return file_.error();
  }

private:
  void writeInterfaces()
  {
    std::string list;
    for (const auto& [one, other] : zones_.interfaces())
    {
      list += (list.empty() ? "" : ", ") + one + ", " + other;
    }
    file_.text("% Several zones: a configuration for each, and one for all with\n");
    file_.text(list.empty() ? "" : "% MARKER_ZONE_INTERFACE= ( " + list + " )\n");
  }

  void writeTypes(const SU2Zone& zone)
  {
    file_.text("% Patches and their types; lines for the configuration\n");
    std::map<std::string, std::string> options;
    for (const SU2Marker& marker : zone.markers)
    {
      file_.text("% ").text(marker.label).text(": ").text(nameOf(marker.type)).text("\n");
      const Option option = optionFor(marker.type);
      std::string& list = options[option.name];
      list += (list.empty() ? "" : ", ") + marker.label + option.values;
    }
    options.erase("");
    for (const auto& [name, list] : options)
    {
      file_.text("% ").text(name).text("= ( ").text(list).text(" )\n");
    }
  }

  void writeElement(const Corners& element, const SU2Zone& zone, bool turned)
  {
    file_.number(SU2Types[static_cast<int>(element.kind)]);
    for (int i = 0; i < element.count; ++i)
    {
      const vtkIdType p = element[turned ? element.count - 1 - i : i];
      file_.text(" ").number(zone.pointNumbers.empty() ? p : zone.pointNumbers[p]);
    }
  }

  void writeCells(const SU2Zone& zone)
  {
    file_.text("NDIME= 3\nNELEM= ").number(zone.cells).text("\n");
    vtkIdType next = 0;
    for (vtkIdType i = 0; i < mesh_.numberOfCells(); ++i)
    {
      if (mesh_.regionOf(i) == zone.region)
      {
        writeElement(mesh_.cell(i), zone, false);
        file_.text(" ").number(next++).text("\n");
      }
    }
  }

  void writePoints(const SU2Zone& zone)
  {
    file_.text("NPOIN= ").number(zone.points).text("\n");
    vtkIdType next = 0;
    for (vtkIdType i = 0; i < mesh_.numberOfPoints(); ++i)
    {
      if (!zone.pointNumbers.empty() && zone.pointNumbers[i] < 0)
      {
        continue;
      }
      for (const double x : mesh_.point(i))
      {
        file_.number(x).text(" ");
      }
      file_.number(next++).text("\n");
    }
  }

  void writeMarkers(const SU2Zone& zone)
  {
    file_.text("NMARK= ").number(zone.markers.size()).text("\n");
    for (const SU2Marker& marker : zone.markers)
    {
      file_.text("MARKER_TAG= ").text(marker.label).text("\nMARKER_ELEMS= ");
      file_.number(marker.faces.size()).text("\n");
      for (const auto& [face, turned] : marker.faces)
      {
        writeElement(mesh_.face(face), zone, turned);
        file_.text("\n");
      }
    }
  }

  const MeshView& mesh_;
  const SU2Zones& zones_;
  OutputFile file_;
};
} // namespace

Outcome vtkSU2MeshWriter::WriteMesh(const MeshView& mesh)
{
  SU2Zones zones(mesh);
  ReplacedPath path(this->FileName, ReplacedPath::Kind::File);
  Outcome outcome = zones.prepare();
  outcome = outcome.ok() ? path.prepare() : outcome;
  if (!outcome.ok())
  {
    return outcome;
  }
  if (const int error = SU2File(mesh, zones, path.temporary()).write())
  {
    return writingFailed(this->FileName, error);
  }
  return path.commit();
}

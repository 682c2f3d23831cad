// The format: https://su2code.github.io/docs_v7/Mesh-File/
#include "vtkSU2MeshWriter.h"

#include "MeshView.h"
#include "OutputFile.h"
#include "PatchLabels.h"
#include "ReplacedPath.h"

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
  SU2File(const MeshView& mesh, const std::string& path)
    : mesh_(mesh)
    , file_(path)
    , patches_(mesh.patches())
    , labels_(patchLabels(patches_, "_-.+"))
  {
  }

  int write()
  {
    writeTypes();
    writeCells();
    writePoints();
    writeMarkers();
    file_.close();
    return file_.error();
  }

private:
  void writeTypes()
  {
    file_.text("% Patches and their types; lines for the configuration\n");
    std::map<std::string, std::string> options;
    for (std::size_t i = 0; i < patches_.size(); ++i)
    {
      file_.text("% ").text(labels_[i]).text(": ").text(nameOf(patches_[i].type)).text("\n");
      const Option option = optionFor(patches_[i].type);
      std::string& list = options[option.name];
      list += (list.empty() ? "" : ", ") + labels_[i] + option.values;
    }
    options.erase("");
    for (const auto& [name, list] : options)
    {
      file_.text("% ").text(name).text("= ( ").text(list).text(" )\n");
    }
  }

  void writeElement(const Corners& element)
  {
    file_.number(SU2Types[static_cast<int>(element.kind)]);
    for (const vtkIdType p : element)
    {
      file_.text(" ").number(p);
    }
  }

  void writeCells()
  {
    file_.text("NDIME= 3\nNELEM= ").number(mesh_.numberOfCells()).text("\n");
    for (vtkIdType i = 0; i < mesh_.numberOfCells(); ++i)
    {
      writeElement(mesh_.cell(i));
      file_.text(" ").number(i).text("\n");
    }
  }

  void writePoints()
  {
    file_.text("NPOIN= ").number(mesh_.numberOfPoints()).text("\n");
    for (vtkIdType i = 0; i < mesh_.numberOfPoints(); ++i)
    {
      for (const double x : mesh_.point(i))
      {
        file_.number(x).text(" ");
      }
      file_.number(i).text("\n");
    }
  }

  void writeMarkers()
  {
    file_.text("NMARK= ").number(patches_.size()).text("\n");
    for (std::size_t i = 0; i < patches_.size(); ++i)
    {
      const BoundaryPatch& patch = patches_[i];
      file_.text("MARKER_TAG= ").text(labels_[i]).text("\nMARKER_ELEMS= ").number(patch.count()).text("\n");
      for (vtkIdType f = patch.first; f < patch.first + patch.count(); ++f)
      {
        writeElement(mesh_.face(f));
        file_.text("\n");
      }
    }
  }

  const MeshView& mesh_;
  OutputFile file_;
  const std::vector<BoundaryPatch>& patches_;
  std::vector<std::string> labels_;
};
} // namespace

Outcome vtkSU2MeshWriter::WriteMesh(const MeshView& mesh)
{
  ReplacedPath path(this->FileName, ReplacedPath::Kind::File);
  if (Outcome outcome = path.prepare(); !outcome.ok())
  {
    return outcome;
  }
  if (const int error = SU2File(mesh, path.temporary()).write())
  {
    return writingFailed(this->FileName, error);
  }
  return path.commit();
}

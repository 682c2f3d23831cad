// The format: gmsh reference manual, "MSH file format version 2 (Legacy)".
#include "vtkGmshMeshWriter.h"

#include "MeshView.h"
#include "OutputFile.h"
#include "PatchLabels.h"
#include "ReplacedPath.h"

#include "vtkObjectFactory.h"

#include <cstdint>
#include <limits>

vtkStandardNewMacro(vtkGmshMeshWriter);

namespace
{
using namespace ransmesh;

constexpr std::array<int, 6> GmshTypes = { 4, 7, 6, 5, 2, 3 }; // by CellKind
constexpr std::size_t LongestName = 127;
constexpr std::string_view Allowed =
  " _-.+:;,/()[]{}<>=*&%$#@!~^|'?"; // all but quotation marks, which end a name

class GmshFile
{
public:
  GmshFile(const MeshView& mesh, const std::string& path, bool binary)
    : mesh_(mesh)
    , file_(path)
    , binary_(binary)
    , labels_(patchLabels(mesh.patches(), Allowed, LongestName))
  {
  }

  int write()
  {
    file_.text("$MeshFormat\n2.2 ").text(binary_ ? "1" : "0").text(" 8\n");
    if (binary_)
    {
      file_.binary(std::int32_t{ 1 }).text("\n"); // tells the order of bytes
    }
    file_.text("$EndMeshFormat\n");
    writeNames();
    writePoints();
    writeElements();
    writeTypes();
    file_.close();
    return file_.error();
  }

private:
  void writeNames()
  {
    const std::vector<std::string> regions = regionLabels(mesh_.regions(), Allowed, LongestName);
    file_.text("$PhysicalNames\n").number(labels_.size() + regions.size()).text("\n");
    for (std::size_t p = 0; p < labels_.size(); ++p)
    {
      file_.text("2 ").number(mesh_.patches()[p].id).text(" \"").text(labels_[p]).text("\"\n");
    }
    for (std::size_t r = 0; r < regions.size(); ++r)
    {
      file_.text("3 ").number(mesh_.regions()[r].id).text(" \"").text(regions[r]).text("\"\n");
    }
    file_.text("$EndPhysicalNames\n");
  }

  void writePoints()
  {
    file_.text("$Nodes\n").number(mesh_.numberOfPoints()).text("\n");
    for (vtkIdType i = 0; i < mesh_.numberOfPoints(); ++i)
    {
      const auto x = mesh_.point(i);
      if (binary_)
      {
        file_.binary(static_cast<std::int32_t>(i + 1)).binary(x[0]).binary(x[1]).binary(x[2]);
      }
      else
      {
        file_.number(i + 1).text(" ").number(x[0]).text(" ").number(x[1]).text(" ").number(x[2]).text("\n");
      }
    }
    file_.text(binary_ ? "\n$EndNodes\n" : "$EndNodes\n");
  }

  void writeElements()
  {
    file_.text("$Elements\n").number(mesh_.numberOfFaces() + mesh_.numberOfCells()).text("\n");
    for (const CellKind kind : { CellKind::Triangle, CellKind::Quadrilateral })
    {
      startBlock(kind);
      for (const BoundaryPatch& patch : mesh_.patches())
      {
        for (vtkIdType f = patch.first; f < patch.first + patch.count(); ++f)
        {
          const Corners face = mesh_.face(f);
          if (face.kind == kind)
          {
            writeElement(face, patch.id);
          }
        }
      }
    }
    for (const CellKind kind : VolumeKinds)
    {
      startBlock(kind);
      mesh_.forEachCell(kind,
        [this](const Corners& cell, std::size_t region) { writeElement(cell, mesh_.regions()[region].id); });
    }
    file_.text(binary_ ? "\n$EndElements\n" : "$EndElements\n");
  }

  // Binary files tell kind, number and tags once for many elements.
  void startBlock(CellKind kind)
  {
    const vtkIdType count = mesh_.numberOfCells(kind);
    if (binary_ && count > 0)
    {
      file_.binary(std::int32_t{ GmshTypes[static_cast<int>(kind)] });
      file_.binary(static_cast<std::int32_t>(count)).binary(std::int32_t{ 2 });
    }
  }

  // tag: of the physical and of the elementary entity.
  void writeElement(const Corners& element, int tag)
  {
    ++element_;
    if (binary_)
    {
      file_.binary(element_).binary(std::int32_t{ tag }).binary(std::int32_t{ tag });
      for (const vtkIdType p : element)
      {
        file_.binary(static_cast<std::int32_t>(p + 1));
      }
      return;
    }
    file_.number(element_).text(" ").number(GmshTypes[static_cast<int>(element.kind)]).text(" 2 ");
    file_.number(tag).text(" ").number(tag);
    for (const vtkIdType p : element)
    {
      file_.text(" ").number(p + 1);
    }
    file_.text("\n");
  }

  void writeTypes()
  {
    file_.text("$Comments\n");
    for (std::size_t p = 0; p < labels_.size(); ++p)
    {
      file_.text("patch ").number(mesh_.patches()[p].id).text(": ").text(nameOf(mesh_.patches()[p].type));
      file_.text("\n");
    }
    file_.text("$EndComments\n");
  }

  const MeshView& mesh_;
  OutputFile file_;
  bool binary_;
  std::vector<std::string> labels_;
  std::int32_t element_ = 0;
};
} // namespace

Outcome vtkGmshMeshWriter::WriteMesh(const MeshView& mesh)
{
  if (mesh.numberOfPoints() >= std::numeric_limits<std::int32_t>::max() ||
    mesh.numberOfCells() + mesh.numberOfFaces() >= std::numeric_limits<std::int32_t>::max())
  {
    return Outcome::badInput("the mesh has too many points or cells for the format's 32-bit numbers");
  }
  ReplacedPath path(this->FileName, ReplacedPath::Kind::File);
  if (Outcome outcome = path.prepare(); !outcome.ok())
  {
    return outcome;
  }
  if (const int error = GmshFile(mesh, path.temporary(), this->FileType == VTK_BINARY).write())
  {
    return writingFailed(this->FileName, error);
  }
  return path.commit();
}

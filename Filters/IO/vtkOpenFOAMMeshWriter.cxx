// The format: OpenFOAM user guide, "Mesh description"; binary files as OpenFOAM 1912 writes them.
#include "vtkOpenFOAMMeshWriter.h"

#include "FoamFaces.h"
#include "PatchLabels.h"
#include "PlaneNormal.h"
#include "ReplacedPath.h"

#include "vtkObjectFactory.h"

#include <filesystem>
#include <limits>

vtkStandardNewMacro(vtkOpenFOAMMeshWriter);

namespace
{
using namespace ransmesh;
using namespace ransmesh::foam;

// OpenFOAM stops where a face normal of a symmetryPlane is 3e-8 off the mean; less is left to rounding.
constexpr double LargestOffPlane = 1e-8;

const char* typeOf(const BoundaryPatch& patch, const MeshView& mesh)
{
  if (patch.type == PatchType::Symmetry)
  {
    return planeNormal(mesh, patch, LargestOffPlane) ? "symmetryPlane" : "symmetry";
  }
  return patch.type == PatchType::Wall ? "wall" : "patch";
}

// OpenFOAM takes what begins with a digit or a sign for a number.
std::vector<std::string> foamLabels(std::vector<BoundaryPatch> patches)
{
  for (BoundaryPatch& patch : patches)
  {
    if (std::string_view("0123456789+-.").find(patch.name[0]) != std::string_view::npos)
    {
      patch.name.insert(0, "patch_");
    }
  }
  return patchLabels(patches, "_-.+:");
}

class PolyMesh
{
public:
  PolyMesh(const MeshView& mesh, const std::string& folder, bool binary)
    : mesh_(mesh)
    , folder_(folder + "/")
    , binary_(binary)
    , faces_(mesh, folder, binary)
    , labels_(foamLabels(mesh.patches()))
  {
  }

  Outcome write()
  {
    writePoints();
    if (Outcome outcome = faces_.write(); !outcome.ok())
    {
      return outcome;
    }
    note(faces_.error());
    writeBoundary();
    if (!faces_.zoneFaces().empty())
    {
      writeZones();
    }
    return Outcome::done();
  }

  int error() const { return error_; }

private:
  void note(int error) { error_ = error_ ? error_ : error; }
  void finish(OutputFile& file)
  {
    file.close();
    note(file.error());
  }

  void writePoints()
  {
    OutputFile file(folder_ + "points");
    file.text(header("points", "vectorField", binary_));
    file.number(mesh_.numberOfPoints()).text(binary_ ? "\n(" : "\n(\n");
    for (vtkIdType i = 0; i < mesh_.numberOfPoints(); ++i)
    {
      const auto x = mesh_.point(i);
      if (binary_)
      {
        file.binary(x[0]).binary(x[1]).binary(x[2]);
      }
      else
      {
        file.text("(").number(x[0]).text(" ").number(x[1]).text(" ").number(x[2]).text(")\n");
      }
    }
    file.text(")\n");
    finish(file);
  }

  void writeBoundary()
  {
    OutputFile file(folder_ + "boundary");
    file.text(header("boundary", "polyBoundaryMesh", false));
    const auto& patches = mesh_.patches();
    const auto outer = [](const BoundaryPatch& p) { return FaceOrder::sidesOf(p) > 0; };
    file.number(std::count_if(patches.begin(), patches.end(), outer)).text("\n(\n");
    for (std::size_t i = 0; i < patches.size(); ++i)
    {
      if (!outer(patches[i]))
      {
        continue;
      }
      file.text("    ").text(labels_[i]).text("\n    {\n        type            ");
      file.text(typeOf(patches[i], mesh_)).text(";\n        inGroups        1(");
      file.text(nameOf(patches[i].type)).text(");\n        nFaces          ");
      file.number(faces_.order().outerFaces(patches[i])).text(";\n        startFace       ");
      file.number(faces_.startOf(i)).text(";\n    }\n");
    }
    file.text(")\n");
    finish(file);
  }

  // Of the faces of a sheet; in text, which OpenFOAM takes beside binary files.
  void writeZone(OutputFile& file, const BoundaryPatch& patch, const std::string& label)
  {
    std::vector<ZoneFace> faces;
    std::copy_if(faces_.zoneFaces().begin(), faces_.zoneFaces().end(), std::back_inserter(faces),
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

  void writeZones()
  {
    OutputFile file(folder_ + "faceZones");
    file.text(header("faceZones", "regIOobject", false));
    const auto& patches = mesh_.patches();
    const auto sheet = [](const BoundaryPatch& p) { return FaceOrder::sidesOf(p) == 0; };
    file.number(std::count_if(patches.begin(), patches.end(), sheet)).text("\n(\n");
    for (std::size_t i = 0; i < patches.size(); ++i)
    {
      if (sheet(patches[i]))
      {
        writeZone(file, patches[i], labels_[i]);
      }
    }
    file.text(")\n");
    finish(file);
  }

  const MeshView& mesh_;
  std::string folder_;
  bool binary_;
  FoamFaces faces_;
  std::vector<std::string> labels_;
  int error_ = 0;
};

// An empty file that ParaView opens a case by.
int writeMarker(const std::string& path)
{
  OutputFile file(path);
  file.close();
  return file.error();
}
} // namespace

Outcome vtkOpenFOAMMeshWriter::WriteMesh(const MeshView& mesh)
{
  const std::filesystem::path asked(this->FileName);
  const bool byMarker = asked.extension() == ".foam";
  const std::string folder =
    byMarker ? (asked.parent_path() / "constant" / "polyMesh").string() : std::string(this->FileName);
  if (mesh.numberOfCells() > std::numeric_limits<std::int32_t>::max() / 6)
  {
    return Outcome::badInput("the mesh has too many cells for labels of 32 bits");
  }
  ReplacedPath path(folder, ReplacedPath::Kind::MeshFolder);
  if (Outcome outcome = path.prepare(); !outcome.ok())
  {
    return outcome;
  }
  PolyMesh polyMesh(mesh, path.temporary(), this->FileType == VTK_BINARY);
  if (Outcome outcome = polyMesh.write(); !outcome.ok())
  {
    return outcome;
  }
  const int error = polyMesh.error() != 0 || !byMarker ? polyMesh.error() : writeMarker(asked.string());
  return error != 0 ? writingFailed(this->FileName, error) : path.commit();
}

void vtkOpenFOAMMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileType: " << this->FileType << '\n';
}
